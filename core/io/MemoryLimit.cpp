#include "core/io/MemoryLimit.h"

#include "core/Error.h"
#include "core/SiFormat.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace asperity {

namespace {

std::optional<std::uint64_t> givenMemory() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing changes the environment after the start
    const char* const given = std::getenv("ASPERITY_MEMORY");
    if (given == nullptr) {
        return std::nullopt;
    }
    const std::string_view text(given);
    std::uint64_t bytes = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), bytes);
    return end.ec == std::errc() && end.ptr == text.data() + text.size() ? std::optional(bytes)
                                                                         : std::nullopt;
}

std::uint64_t machineMemory() {
    return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::string bytesText(std::uint64_t bytes) { return formatSi(static_cast<double>(bytes), "B"); }

}  // namespace

std::uint64_t memoryForInput() { return givenMemory().value_or(machineMemory()) / 2; }

void requireMemory(std::uint64_t needed, const std::string& file, const std::string& location) {
    const std::uint64_t most = memoryForInput();
    if (needed > most) {
        throw InputError(file, location,
                         "it takes " + bytesText(needed) + " of memory; expected at most " +
                             bytesText(most) + ", half of the machine's");
    }
}

void requireUsualPacking(std::uint64_t decoded, std::uint64_t packed, const std::string& file,
                         const std::string& location) {
    constexpr std::uint64_t kInAnyWay = std::uint64_t{1} << 30U;
    constexpr std::uint64_t kUsual = 64;
    if (decoded > kInAnyWay && decoded / kUsual > packed) {
        throw InputError(file, location,
                         "its images decode to " + bytesText(decoded) + " or more; of a file of " +
                             bytesText(packed) + " at most " +
                             bytesText(std::max(kInAnyWay, packed * kUsual)) + " are expected");
    }
}

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
