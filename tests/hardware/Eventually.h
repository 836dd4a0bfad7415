#pragma once

#include <chrono>
#include <thread>

namespace asperity::test {

/// Waits until something that another thread brings about is so.
/// @return false when it is not so after a time that no machine needs
template <typename Condition>
[[nodiscard]] bool eventually(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace asperity::test
