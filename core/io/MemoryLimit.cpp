#include "core/io/MemoryLimit.h"

#include "core/Error.h"
#include "core/SiFormat.h"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>
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

}  // namespace

std::uint64_t memoryForInput() { return givenMemory().value_or(machineMemory()) / 2; }

void requireMemory(std::uint64_t needed, const std::string& file, const std::string& place) {
    const std::uint64_t most = memoryForInput();
    if (needed > most) {
        const auto text = [](std::uint64_t bytes) {
            return formatSi(static_cast<double>(bytes), "B");
        };
        throw InputError(file, place,
                         "it takes " + text(needed) + " of memory; expected at most " + text(most) +
                             ", half of the machine's");
    }
}

}  // namespace asperity
