#include "core/Error.h"
#include "core/io/heightmap/x3p/X3pDescription.h"

#include <cstdint>
#include <cstdlib>

// The XML of an X3P file by itself: in the archive, its CRC stops what a fuzzer changes in it.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const asperity::X3pDescription description =
            asperity::describeX3p({reinterpret_cast<const char*>(data), size}, "fuzz", "main.xml");
        const bool whole =
            description.listed
                ? description.listed->size() / sizeof(double) == description.numbers()
                : description.type && !description.points.entry.empty();
        if (!whole) {
            std::abort();
        }
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
