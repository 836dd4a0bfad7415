#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace asperity {

/// The first line that a command prints; empty when it prints none.
inline std::string firstLineOf(const std::string& command) {
    // NOLINTNEXTLINE(cert-env33-c): a program of a benchmark's own, run on purpose
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::array<char, 256> line{};
    if (!pipe || std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) == nullptr) {
        return {};
    }
    return line.data();
}

}  // namespace asperity
