#include "core/FreshMemory.h"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace asperity {

void requestPages(void* memory, std::size_t bytes) noexcept {
    constexpr std::size_t kWorthACall = std::size_t{1} << 16U;
    constexpr std::size_t kWorthLargePages = std::size_t{1} << 22U;
    if (bytes < kWorthACall) {
        return;
    }
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    void* const first = reinterpret_cast<void*>(begin);  // NOLINT(performance-no-int-to-ptr)
    if (bytes >= kWorthLargePages) {
        (void)madvise(first, end - begin, MADV_HUGEPAGE);
    }
#ifdef MADV_POPULATE_WRITE
    (void)madvise(first, end - begin, MADV_POPULATE_WRITE);
#endif
}

}  // namespace asperity
