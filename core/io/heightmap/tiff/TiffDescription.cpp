#include "core/io/heightmap/tiff/TiffDescription.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightCounts.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/tiff/TiffImage.h"

#include <cmath>

namespace asperity {

namespace {

/// Lines "key=value".
ImageTexts lines(std::string_view text) {
    ImageTexts texts;
    for (const std::string_view line : linesOf(text)) {
        const std::size_t equals = line.find('=');
        if (equals != std::string_view::npos) {
            texts.emplace(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
        }
    }
    return texts;
}

/// Texts and numbers of `{"key": "text", "key": 1.5}`; nothing within them is looked at.
ImageTexts members(std::string_view text) {
    ImageTexts texts;
    std::size_t open = text.find('"');
    while (open != std::string_view::npos) {
        const std::size_t close = text.find('"', open + 1);
        const std::size_t start = text.find_first_not_of(" :\t\r\n", close + 1);
        if (close == std::string_view::npos || start == std::string_view::npos) {
            return texts;
        }
        const bool quoted = text[start] == '"';
        const std::size_t first = start + (quoted ? 1 : 0);
        const std::size_t end =
            std::min(text.find_first_of(quoted ? "\"" : ",}]", first), text.size());
        texts.emplace(text.substr(open + 1, close - open - 1),
                      trimmed(text.substr(first, end - first)));
        open = text.find('"', end + (quoted ? 1 : 0));
    }
    return texts;
}

std::string textIn(const ImageTexts& texts, const std::string& key) {
    const auto found = texts.find(key);
    return found == texts.end() ? std::string() : found->second;
}

std::optional<double> numberIn(const ImageTexts& texts, const std::string& key) {
    return parseNumber(textIn(texts, key));
}

bool isUnsigned(SampleType type) {
    return type == SampleType::UInt16 || type == SampleType::UInt32;
}

/// What tifffile was given: `unit` and `quantity` of the values, or the heights of both ends.
ImageScale bracedScale(const ImageTexts& texts, SampleType type) {
    ImageScale scale;
    scale.title = textIn(texts, "quantity");
    const std::optional<double> lowest = numberIn(texts, "zmin_m");
    const std::optional<double> highest = numberIn(texts, "zmax_m");
    if (lowest && highest && isUnsigned(type)) {
        scale.unit = "m";
        setEnds(scale, type, *lowest, *highest, "description, zmin_m and zmax_m");
    } else if (!textIn(texts, "unit").empty()) {
        const PhysicalUnit unit = parseUnit(textIn(texts, "unit"));
        scale.unit = unit.base;
        scale.factor = unit.factor;
        scale.provenance.push_back(scaleProvenance(unit.factor, unit.base, "description, unit"));
    }
    return scale;
}

/// ImageJ's words for a unit, of which some are its own.
PhysicalUnit imageJUnit(const std::string& text) {
    if (lowerCase(text).starts_with("micron") || text == "\\u00B5m") {
        return parseUnit("um");
    }
    return parseUnit(text);
}

/// ImageJ calibrates values by a straight line (cf = 0): c0 + c1 * count.
ImageScale imageJScale(const ImageTexts& texts) {
    constexpr double kStraightLine = 0.0;
    ImageScale scale;
    const PhysicalUnit unit = imageJUnit(textIn(texts, "vunit"));
    const std::optional<double> offset = numberIn(texts, "c0");
    const std::optional<double> slope = numberIn(texts, "c1");
    const bool isNumber = unit.base.empty() || lowerCase(unit.base) == "gray value";
    if (!isNumber && numberIn(texts, "cf") == kStraightLine && offset && slope) {
        scale.unit = unit.base;
        scale.factor = *slope * unit.factor;
        scale.offset = *offset * unit.factor;
        scale.provenance.push_back({"scale",
                                    exactText(scale.factor) + " " + scale.unit + " per count, " +
                                        exactText(scale.offset) + " at 0",
                                    "ImageJ's c0, c1 and vunit"});
    }
    return scale;
}

/// Unit of the resolution [m]; empty when it is none.
PhysicalUnit resolutionUnit(const TiffDirectory& directory, const ImageTexts& imageJ) {
    constexpr std::int64_t kNone = 1;
    constexpr std::int64_t kInch = 2;
    constexpr std::int64_t kCentimeter = 3;
    const std::int64_t unit = directory.integer(number(TiffTag::ResolutionUnit)).value_or(kInch);
    const std::string named = textIn(imageJ, "unit");
    if (!named.empty() && unit != kCentimeter && (unit == kNone || named != "inch")) {
        return imageJUnit(named);
    }
    if (unit == kCentimeter) {
        return {0.01, "m"};
    }
    return unit == kInch ? PhysicalUnit{0.0254, "m"} : PhysicalUnit{1.0, ""};
}

void takeResolution(ImageScale& scale, const TiffDirectory& directory, const ImageTexts& imageJ,
                    ImageSize size) {
    // Printers have pixels of 10 um and more, and programs that know no size state such ones.
    constexpr double kMinPrintPitch = 10e-6;
    const std::optional<double> across = directory.number(number(TiffTag::XResolution));
    const std::optional<double> down = directory.number(number(TiffTag::YResolution));
    if (!across || !down) {
        return;
    }
    const PhysicalUnit unit = resolutionUnit(directory, imageJ);
    const double pitchX = unit.factor / *across;
    const double pitchY = unit.factor / *down;
    const bool stated = unit.base == "m" && pitchX > 0.0 && pitchY > 0.0;
    if (!stated || !std::isfinite(pitchX) || !std::isfinite(pitchY)) {
        return;
    }
    if (std::max(pitchX, pitchY) >= kMinPrintPitch && textIn(imageJ, "unit").empty()) {
        scale.notes.emplace_back("its resolution is that of a print and says nothing of the scan");
        return;
    }
    scale.lateralUnit = "m";
    scale.sizeX = pitchX * size.columns;
    scale.sizeY = pitchY * size.rows;
    scale.sizeSource = "XResolution, YResolution";
}

}  // namespace

ImageTexts tiffMetadata(const TiffDirectory& directory) {
    const std::string text = directory.text(number(TiffTag::ImageDescription));
    if (!text.starts_with("Gwy::")) {
        return {};
    }
    ImageTexts texts = lines(text);
    std::erase_if(texts, [](const auto& entry) {
        return entry.first.starts_with("Gwy::") || entry.first == kNoDataKey;
    });
    return texts;
}

ImageScale tiffScale(const TiffDirectory& directory, ImageSize size, SampleType type) {
    const std::string text = directory.text(number(TiffTag::ImageDescription));
    const ImageTexts texts = lines(text);
    const bool isImageJ = text.starts_with("ImageJ=");
    ImageScale scale;
    if (text.find("Gwy::") != std::string::npos) {
        scale = gwyScale(texts, type, directory.bytes().name(), "description,");
    } else if (isImageJ) {
        scale = imageJScale(texts);
    } else if (text.starts_with("{")) {
        scale = bracedScale(members(text), type);
    }
    const bool hasSize = scale.sizeX > 0.0 && scale.sizeY > 0.0;
    if (!hasSize) {
        takeResolution(scale, directory, isImageJ ? texts : ImageTexts(), size);
    }
    return scale;
}

}  // namespace asperity
