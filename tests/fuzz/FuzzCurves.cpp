#include "core/Error.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/CurveSegments.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

// One reader of force curves, whatever the bytes start with: it must give curves whose arrays have
// the same length, or throw an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kMostCurves = 4;
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const asperity::MemoryBytes source(bytes, "fuzz");
        const auto curves = asperity::ASPERITY_FUZZED.open(source, {});
        for (std::size_t i = 0; i < std::min(curves->count(), kMostCurves); ++i) {
            (void)curves->position(i);
            for (const asperity::CurveSegment& segment : curves->read(i).curve.segments) {
                const std::size_t points = asperity::loadOf(segment).size();
                for (const auto array : asperity::kCurveArrays) {
                    if (!(segment.*array).empty() && (segment.*array).size() != points) {
                        std::abort();
                    }
                }
            }
        }
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
