#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace asperity {

/// Passes the latest value of one thread to one other. Neither ever waits: values that nobody read
/// are overwritten.
template <typename T>
class TripleBuffer {
public:
    TripleBuffer() = default;
    explicit TripleBuffer(const T& initial) : slots_{Slot{initial}, Slot{initial}, Slot{initial}} {}

    /// Writer thread only; wait-free.
    void write(const T& value) noexcept {
        slots_[writing_].value = value;
        writing_ = middle_.exchange(writing_ | kFresh, std::memory_order_acq_rel) & kIndex;
    }

    /// Reader thread only; wait-free. The reference holds until the next call.
    const T& read() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0) {
            reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
        }
        return slots_[reading_].value;
    }

private:
    /// Each slot in cache lines of its own: the threads do not slow one another.
    struct alignas(64) Slot {
        T value{};
    };
    static constexpr std::uint32_t kIndex = 3;
    static constexpr std::uint32_t kFresh = 4;

    std::array<Slot, 3> slots_{};
    alignas(64) std::atomic<std::uint32_t> middle_{1};
    alignas(64) std::uint32_t writing_ = 0;
    alignas(64) std::uint32_t reading_ = 2;
};

}  // namespace asperity
