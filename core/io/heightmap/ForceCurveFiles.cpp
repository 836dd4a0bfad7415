#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"

#include <algorithm>

// Files that hold force curves and no image, by marks near their beginning. Readers of formats that
// may hold both see them first and name them themselves. Source: docs/formats.md 0.

namespace asperity {

namespace {

constexpr std::uint64_t kLooked = std::uint64_t{1} << 16U;  // [bytes]

bool contains(std::string_view text, std::string_view mark) {
    return text.find(mark) != std::string_view::npos;
}

std::string_view firstLine(std::string_view text) { return text.substr(0, text.find('\n')); }

bool isJpkText(std::string_view start) {
    return start.starts_with('#') && contains(start, "\n# fancyNames:") &&
           contains(start, "\n# columns:");
}

bool isNanoscopeText(std::string_view start) {
    const bool quoted = start.starts_with("\"\\*") && contains(start, "force image list");
    return quoted || start.starts_with("\"\\*Force file list") ||
           start.starts_with("?*Force file list") || contains(firstLine(start), "Calc_Ramp_") ||
           contains(firstLine(start), "Defl_V_");
}

bool isNanonisSpectroscopy(std::string_view start) {
    return start.starts_with("Experiment\t") && contains(start, "\n[DATA]");
}

bool isParkPinPoint(std::string_view start) { return start.starts_with("PS-PPT/"); }

struct ForceCurveMark {
    std::string_view program;  ///< whose curves they are
    bool (*isOn)(std::string_view start);
};

constexpr std::array<ForceCurveMark, 4> kMarks = {{
    {"JPK, exported as text", isJpkText},
    {"NanoScope, exported as text", isNanoscopeText},
    {"Nanonis spectroscopy, .dat", isNanonisSpectroscopy},
    {"Park PinPoint, .ps-ppt", isParkPinPoint},
}};

/// Null when there is none.
const ForceCurveMark* markOn(const ByteSource& bytes) {
    const std::string start = bytes.start(kLooked);
    const auto* const mark = std::ranges::find_if(
        kMarks, [&start](const ForceCurveMark& each) { return each.isOn(start); });
    return mark == kMarks.end() ? nullptr : mark;
}

StoredScan refuse(const ByteSource& bytes) {
    const ForceCurveMark* const mark = markOn(bytes);
    throw InputError(bytes.name(), "",
                     "this file holds force curves" +
                         (mark == nullptr ? "" : " (" + std::string(mark->program) + ")") +
                         " and no image");
}

}  // namespace

const HeightMapFormat kForceCurveFormat = {
    .name = "force curves",
    .extensions = {},
    .recognizes = [](const ByteSource& bytes) { return markOn(bytes) != nullptr; },
    .read = refuse,
    .isRefused = true};

}  // namespace asperity
