#pragma once

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <sys/mman.h>
#include <vector>

namespace asperity {

/// Leaves new numbers as they are, so that the first pass over a large scan is the one that writes
/// its pixels, and asks for large memory pages, which cost far fewer faults.
template <class Number>
struct PixelAllocator {
    using value_type = Number;

    PixelAllocator() = default;
    template <class Other>
    explicit PixelAllocator(const PixelAllocator<Other>& /*other*/) {}

    // NOLINTBEGIN(cppcoreguidelines-no-malloc): an allocator manages memory by hand
    [[nodiscard]] Number* allocate(std::size_t count) {
        constexpr std::size_t kMax = std::numeric_limits<std::ptrdiff_t>::max() - kLargePage;
        if (count > kMax / sizeof(Number)) {
            throw std::bad_alloc();
        }
        const std::size_t bytes = count * sizeof(Number);
        const bool large = bytes >= kLargePage;
        const std::size_t rounded = (bytes + kLargePage - 1) / kLargePage * kLargePage;
        void* memory = large ? std::aligned_alloc(kLargePage, rounded) : std::malloc(bytes);
        if (memory == nullptr) {
            throw std::bad_alloc();
        }
        if (large) {
            // Advice only: without it all is as before, but slower.
            (void)madvise(memory, rounded, MADV_HUGEPAGE);
        }
        return static_cast<Number*>(memory);
    }
    void deallocate(Number* memory, std::size_t /*count*/) noexcept { std::free(memory); }
    // NOLINTEND(cppcoreguidelines-no-malloc)

    void construct(Number* /*item*/) noexcept {}
    template <class Value>
    void construct(Number* item, const Value& value) noexcept {
        *item = value;
    }

    friend bool operator==(const PixelAllocator&, const PixelAllocator&) { return true; }

private:
    static constexpr std::size_t kLargePage = std::size_t{1} << 21U;  // [bytes]
};

/// Vector for the pixels of large scans; PixelVector<float>(count) has any values.
template <class Number>
using PixelVector = std::vector<Number, PixelAllocator<Number>>;

/// A bit for each pixel of a scan; of two threads only one may write at a time.
using PixelMask = std::vector<bool>;

}  // namespace asperity
