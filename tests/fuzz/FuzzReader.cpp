#include "core/Error.h"
#include "tests/fuzz/WholeScan.h"

#include <cstdint>
#include <string_view>

// One reader, whatever the bytes start with: it must give whole channels or throw an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const asperity::MemoryBytes source(bytes, "fuzz");
        asperity::requireWhole(asperity::ASPERITY_FUZZED.read(source), source);
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
