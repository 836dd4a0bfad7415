#include "core/io/heightmap/ForceCurveFiles.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
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

bool isAfmWorkshop(std::string_view start) {
    return trimmed(firstLine(start)).starts_with("Force-Distance Curve") ||
           (contains(start, "Extend Z-Sense(") && contains(start, "Retract Z-Sense("));
}

/// The tables that the package afmformats exports: metadata as comments, and titles of columns.
bool isCurveTable(std::string_view start) {
    const bool titled = contains(start, "force") &&
                        (contains(start, "tip position") || contains(start, "height (measured)") ||
                         contains(start, "height (piezo)"));
    return start.starts_with('#') &&
           (contains(start, "\"imaging mode\":") || (titled && contains(start, "segment")));
}

/// The tables that `asperity convert` writes.
bool isOwnTable(std::string_view start) {
    return start.starts_with("segment,time_s,") || contains(start, "\nsegment,time_s,");
}

bool isParkPinPoint(std::string_view start) { return start.starts_with("PS-PPT/"); }

struct ForceCurveMark {
    std::string_view program;  ///< whose curves they are
    bool (*isOn)(std::string_view start);
    bool isRead = false;  ///< as curves
};

constexpr std::array<ForceCurveMark, 7> kMarks = {{
    {"JPK, exported as text", isJpkText},
    {"NanoScope, exported as text", isNanoscopeText},
    {"Nanonis spectroscopy, .dat", isNanonisSpectroscopy},
    {"Park PinPoint, .ps-ppt", isParkPinPoint},
    {"AFM Workshop", isAfmWorkshop, true},
    {"a table of Asperity", isOwnTable, true},
    {"a table of afmformats, .tab", isCurveTable},
}};

/// Frames of an NT-MDT file follow each other, each with its length and its type.
bool holdsNtMdtCurvesAlone(const ByteSource& bytes) {
    constexpr std::string_view kMdtMagic = "\x01\xB0\x93\xFF";
    constexpr std::uint64_t kLastFrame = 12;
    constexpr std::uint64_t kFirstFrame = 33;
    constexpr std::uint64_t kFrameStart = 6;
    constexpr std::array<std::uint16_t, 3> kCurves{1, 190, 201};
    if (!bytes.startsWith(kMdtMagic) || bytes.size() < kFirstFrame) {
        return false;
    }
    const auto frames = numberIn<std::uint16_t>(bytes, {kLastFrame, sizeof(std::uint16_t)});
    std::uint64_t offset = kFirstFrame;
    for (int frame = 0; frame <= frames; ++frame) {
        if (offset + kFrameStart > bytes.size()) {
            return false;
        }
        const std::string start = bytesOf(bytes, {offset, kFrameStart});
        const auto length = littleEndian<std::uint32_t>(start.data());
        const auto type = littleEndian<std::uint16_t>(start.data() + sizeof(length));
        if (length < kFrameStart || std::ranges::count(kCurves, type) == 0) {
            return false;
        }
        offset += length;
    }
    return true;
}

constexpr ForceCurveMark kNtMdt{"NT-MDT .mdt", nullptr};

/// Null when there is none.
const ForceCurveMark* markOn(const ByteSource& bytes) {
    if (holdsNtMdtCurvesAlone(bytes)) {
        return &kNtMdt;
    }
    const std::string start = bytes.start(kLooked);
    const auto* const mark = std::ranges::find_if(
        kMarks, [&start](const ForceCurveMark& each) { return each.isOn(start); });
    return mark == kMarks.end() ? nullptr : mark;
}

StoredScan refuse(const ByteSource& bytes) {
    const ForceCurveMark* const mark = markOn(bytes);
    const bool isRead = mark != nullptr && mark->isRead;
    throw InputError(bytes.name(), "",
                     "this file holds force curves" +
                         (mark == nullptr ? "" : " (" + std::string(mark->program) + ")") +
                         " and no image" + std::string(isRead ? kCurvePointer : ""));
}

}  // namespace

std::string forceCurveProgram(const ByteSource& bytes) {
    const ForceCurveMark* const mark = markOn(bytes);
    return mark == nullptr ? std::string() : std::string(mark->program);
}

const HeightMapFormat kForceCurveFormat = {
    .name = "force curves",
    .extensions = {},
    .recognizes = [](const ByteSource& bytes) { return markOn(bytes) != nullptr; },
    .read = refuse,
    .isRefused = true};

}  // namespace asperity
