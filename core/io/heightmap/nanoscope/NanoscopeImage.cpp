#include "core/io/heightmap/nanoscope/NanoscopeImage.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

// Source: docs/formats.md 3.

namespace asperity {

namespace {

struct ListedFactor {
    NanoscopeList list;
    std::string_view key;  ///< empty: none
    bool divides = false;
};

/// Parts of the scale of an image that has none of its own.
struct OldKind {
    std::string_view name;  ///< "Image data"
    std::string_view zScale;
    std::string_view unit;
    double factor;
    std::array<ListedFactor, 3> listed;
};

constexpr double kNano = 1e-9;
constexpr double kPerCount = 2.0 / 65536.0;  ///< counts reach from -max to max
constexpr ListedFactor kNone{NanoscopeList::Scan, ""};
constexpr ListedFactor kInputMax{NanoscopeList::Controller, "In1 max"};
constexpr ListedFactor kInput{NanoscopeList::Scanner, "In sensitivity"};
constexpr ListedFactor kDetector{NanoscopeList::Scan, "Detect sens.", true};

constexpr std::array<OldKind, 6> kOldKinds{
    {{"Height",
      "Z scale height",
      "m",
      kNano* kPerCount,
      {{{NanoscopeList::Controller, "Z max"}, {NanoscopeList::Scanner, "Z sensitivity"}, kNone}}},
     {"Deflection", "Z scale defl", "m", kNano* kPerCount, {{kInputMax, kInput, kDetector}}},
     {"Amplitude", "Z scale ampl", "m", kNano* kPerCount, {{kInputMax, kInput, kDetector}}},
     {"Current", "Z scale amplitude", "A", kNano * 2.0 / 32768.0, {{kInputMax, kInput, kNone}}},
     {"Frequency", "Z scale freq", "Hz", 25e6 / 32768.0, {{kNone, kNone, kNone}}},
     {"Phase", "Z scale phase", "deg", 180.0 / 65536.0, {{kNone, kNone, kNone}}}}};

std::optional<double> numberOf(const std::string* text) {
    const std::optional<LeadingNumber> number =
        text == nullptr ? std::nullopt : parseLeadingNumber(*text);
    return number && std::isfinite(number->value) ? std::optional(number->value) : std::nullopt;
}

std::optional<OldScale> statedScale(const std::string& text) {
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    if (!number || !std::isfinite(number->value)) {
        return std::nullopt;
    }
    const PhysicalUnit unit = parseUnit(number->rest.substr(0, number->rest.find('(')));
    return OldScale{number->value * unit.factor, unit.base, ", Z scale"};
}

std::optional<OldScale> scaleOfKind(const OldKind& kind, const NanoscopeSection& image,
                                    const FindInList& findInList) {
    const std::optional<double> own = numberOf(image.find(kind.zScale));
    if (!own) {
        return std::nullopt;
    }
    OldScale scale{kind.factor * *own, std::string(kind.unit), ", " + std::string(kind.zScale)};
    for (const ListedFactor& each : kind.listed) {
        if (each.key.empty()) {
            continue;
        }
        const std::string key(each.key);
        const std::optional<double> number = numberOf(findInList(each.list, key));
        if (!number || (each.divides && *number == 0.0)) {
            return std::nullopt;
        }
        scale.fullScale *= each.divides ? 1.0 / *number : *number;
        scale.source += ", " + key;
    }
    return scale;
}

/// From this version on samples have 32 bits, whatever "Bytes/pixel" says.

/// The unit of a value after its sensitivity: "m/V" times "V" is "m".
std::string productUnit(const std::string& sensitivity, const std::string& hard) {
    const std::string divisor = "/" + hard;
    if (sensitivity.empty()) {
        return hard;
    }
    if (!hard.empty() && sensitivity.ends_with(divisor)) {
        return sensitivity.substr(0, sensitivity.size() - divisor.size());
    }
    return hard.empty() ? sensitivity : sensitivity + " " + hard;
}

/// Returns whether it is the ratio of no square. Gwyddion looks at the number before the colon.
bool isNonSquare(const std::string* text) {
    if (text == nullptr || *text == "1:1") {
        return false;
    }
    const std::optional<LeadingNumber> ratio = parseLeadingNumber(*text);
    return ratio && ratio->value > 0.0 && ratio->value != 1.0;
}

/// The whole number at the start of a text, such as that of "512 512"; 0: there is none that an
/// image may have.
long long leadingCount(const std::string* text) {
    constexpr double kMaxSide = 65536.0;
    const std::optional<LeadingNumber> number =
        text == nullptr ? std::nullopt : parseLeadingNumber(*text);
    const bool good = number && number->value >= 1.0 && number->value <= kMaxSide;
    return good ? static_cast<long long>(number->value) : 0;
}

}  // namespace

std::optional<OldScale> oldNanoscopeScale(const NanoscopeSection& image,
                                          const FindInList& findInList) {
    if (const std::string* const stated = image.find("Z scale")) {
        return statedScale(*stated);
    }
    const std::string* const name = image.find("Image data");
    const auto* const kind = std::ranges::find_if(kOldKinds, [name](const OldKind& each) {
        return name != nullptr && lowerCase(each.name) == lowerCase(*name);
    });
    return kind == kOldKinds.end() ? std::nullopt : scaleOfKind(*kind, image, findInList);
}

NanoscopeImage::NanoscopeImage(const std::vector<NanoscopeSection>& sections,
                               const NanoscopeSection& image, std::string file, std::string list)
    : sections_(&sections), image_(&image), file_(std::move(file)), list_(std::move(list)) {}

std::string NanoscopeImage::name() const {
    for (const char* const key : {"@2:Image Data", "@3:Image Data", "@4:Image Data"}) {
        const std::string* const entry = image_->find(key);
        const std::optional<CiaoValue> value = entry ? parseCiaoValue(*entry) : std::nullopt;
        if (!value) {
            continue;
        }
        const std::string& name = value->bracket.empty() ? value->text : value->bracket;
        return name.empty() ? list_ : name;
    }
    const std::string* const old = image_->find("Image data");
    return old == nullptr || old->empty() ? list_ : *old;
}

std::string NanoscopeImage::direction() const {
    const std::string* entry = image_->find("Line direction");
    return entry ? directionFromName(*entry) : std::string();
}

ImageSize NanoscopeImage::ownSize() const {
    const std::string location = list_ + ": Samps/line, Number of lines";
    if (image_->find("Number of lines") == nullptr) {
        // NanoScope E: both are in one line.
        const std::string& both = require("Samps/line");
        const std::optional<LeadingNumber> first = parseLeadingNumber(both);
        const std::string rest = first ? std::string(first->rest) : std::string();
        return checkedImageSize(leadingCount(&both), leadingCount(&rest), file_, location);
    }
    return checkedImageSize(integer("Samps/line"), integer("Number of lines"), file_, location);
}

NanoscopeLayout NanoscopeImage::layout() const {
    const ImageSize own = ownSize();
    const ScanGrid grid = scanGrid();
    NanoscopeLayout layout;
    layout.sampleBytes = storedSampleBytes();
    const long long offset = integer("Data offset");
    const long long length = integer("Data length");
    if (offset <= 0 || length <= 0 || !fitSize(layout, own, grid, length)) {
        fail("'Data offset' " + std::to_string(offset) + " and 'Data length' " +
             std::to_string(length) + " do not fit " + std::to_string(own.columns) + " x " +
             std::to_string(own.rows) + " samples of " + std::to_string(layout.sampleBytes) +
             " bytes");
    }
    layout.offset = static_cast<std::uint64_t>(offset);
    readScanSize(layout, own, grid);
    return layout;
}

NanoscopeLayout NanoscopeImage::layoutOf(std::uint64_t values) const {
    const ImageSize own = ownSize();
    const ScanGrid grid = scanGrid();
    NanoscopeLayout layout;
    layout.sampleBytes = 1;
    if (!fitSize(layout, own, grid, static_cast<long long>(values)) ||
        layout.size.pixels() != values) {
        fail("it promises " + std::to_string(own.columns) + " x " + std::to_string(own.rows) +
             " values, and there are " + std::to_string(values) +
             "; the file is truncated or damaged");
    }
    readScanSize(layout, own, grid);
    return layout;
}

NanoscopeImage::ScanGrid NanoscopeImage::scanGrid() const {
    ScanGrid grid;
    for (const NanoscopeSection& section : *sections_) {
        if (&section == image_) {
            break;
        }
        if (isNamed(section, kNanoscopeGridLists)) {
            const long long columns = leadingCount(section.find("Samps/line"));
            const long long rows = leadingCount(section.find("Lines"));
            grid.columns = columns > 0 ? columns : grid.columns;
            grid.rows = rows > 0 ? rows : grid.rows;
            grid.hasAspect = isNonSquare(section.find("Aspect ratio"));
        }
    }
    return grid;
}

/// Does as Gwyddion: takes the size that is exactly as long as the data; else the larger one of
/// those that are shorter. Else the scan was stopped, and the data are its first lines.
bool NanoscopeImage::fitSize(NanoscopeLayout& layout, ImageSize own, const ScanGrid& grid,
                             long long length) {
    const long long rowBytes = static_cast<long long>(own.columns) * layout.sampleBytes;
    const long long ownBytes = rowBytes * own.rows;
    const long long columns = grid.columns > 0 ? grid.columns : own.columns;
    const long long rows = grid.rows > 0 ? grid.rows : own.rows;
    const long long scanBytes = columns * rows * layout.sampleBytes;
    const bool isExact = length == ownBytes || length == scanBytes;
    layout.isOfScan = isExact ? length != ownBytes
                              : scanBytes < length && (scanBytes > ownBytes || ownBytes > length);
    layout.size =
        layout.isOfScan ? ImageSize{static_cast<int>(columns), static_cast<int>(rows)} : own;
    layout.plannedRows = layout.size.rows;
    if (layout.isOfScan || length >= ownBytes) {
        return true;
    }
    layout.size.rows = static_cast<int>(length / rowBytes);
    return length > 0 && length % rowBytes == 0;
}

std::optional<NanoscopeImage::ScanSize> NanoscopeImage::scanSizeIn(const std::string* text) {
    const std::optional<LeadingNumber> x =
        text == nullptr ? std::nullopt : parseLeadingNumber(*text);
    if (!x) {
        return std::nullopt;
    }
    const std::optional<LeadingNumber> y = parseLeadingNumber(x->rest);
    const PhysicalUnit unit = parseUnit(y ? y->rest : x->rest);
    if (unit.base != "m") {
        return std::nullopt;
    }
    return ScanSize{x->value * unit.factor, (y ? y->value : x->value) * unit.factor};
}

/// Does as Gwyddion, docs/formats.md 3.
void NanoscopeImage::readScanSize(NanoscopeLayout& layout, ImageSize own,
                                  const ScanGrid& grid) const {
    const std::string* text = image_->find("Scan size");
    if (text == nullptr) {
        text = findIn(kNanoscopeScanLists, "Scan size");
    }
    const std::optional<ScanSize> size = scanSizeIn(text);
    if (!size) {
        fail("expected 'Scan size' with one or two numbers and a unit of length");
    }
    layout.sizeX = std::abs(size->x);
    layout.sizeY = std::abs(size->y);
    if (layout.isOfScan) {
        layout.sizeX *= static_cast<double>(layout.size.columns) / own.columns;
        layout.sizeY *= static_cast<double>(layout.plannedRows) / own.rows;
    } else if (isNonSquare(image_->find("Aspect ratio"))) {
        const long long scanRows = grid.rows > 0 ? grid.rows : own.rows;
        layout.sizeY *= static_cast<double>(own.rows) /
                        static_cast<double>(grid.hasAspect ? own.columns : scanRows);
    }
    layout.sizeY *= static_cast<double>(layout.size.rows) / layout.plannedRows;
}

NanoscopeScale NanoscopeImage::oldScale() const {
    const std::optional<OldScale> scale = oldNanoscopeScale(
        *image_, [this](NanoscopeList list, const std::string& key) { return findIn(list, key); });
    if (!scale) {
        fail("it has no '@2:Z scale', nor what NanoScope before version 4.3 has in its place");
    }
    return {std::ldexp(scale->fullScale, -8 * bytesPerPixel()), scale->unit, list_ + scale->source};
}

NanoscopeScale NanoscopeImage::scale() const {
    const std::string* entry = nullptr;
    std::string key;
    for (const char* const each : {"@4:Z scale", "@2:Z scale", "@3:Z scale"}) {
        if (entry == nullptr) {
            entry = image_->find(each);
            key = each;
        }
    }
    if (entry == nullptr || image_->find("Z scale") != nullptr) {
        return oldScale();
    }
    const std::optional<CiaoValue> value = parseCiaoValue(*entry);
    if (!value || !value->number) {
        fail("'" + key + "': expected 'V [..] (..) number unit', found '" + *entry + "'");
    }
    const PhysicalUnit hard = parseUnit(value->unit);
    const double fullScale = std::ldexp(1.0, 8 * bytesPerPixel());
    NanoscopeScale scale = sensitivity(value->bracket, hard.base);
    // A signal that no sensitivity turns into something else keeps the unit that it is shown in at
    // the instrument (mV): only lengths are geometry and must be in meters.
    const bool keepsUnit = scale.unit == hard.base && hard.base != "m" && hard.factor != 1.0;
    if (keepsUnit) {
        scale.unit = value->unit;
    }
    scale.source = list_ + ", " + key + scale.source;
    scale.factor *= *value->number * (keepsUnit ? 1.0 : hard.factor) / fullScale;
    return scale;
}

NanoscopeScale NanoscopeImage::sensitivity(const std::string& softScale,
                                           const std::string& hardUnit) const {
    if (softScale.empty()) {
        return {1.0, hardUnit, ""};
    }
    const std::string* entry = findIn(kNanoscopeScannerLists, "@" + softScale);
    if (entry == nullptr) {
        entry = findIn(kNanoscopeScanLists, "@" + softScale);
    }
    if (entry == nullptr) {
        return {1.0, hardUnit, ""};
    }
    const std::optional<CiaoValue> value = parseCiaoValue(*entry);
    if (!value || !value->number) {
        fail("'" + softScale + "': expected 'V number unit', found '" + *entry + "'");
    }
    const PhysicalUnit unit = parseUnit(value->unit);
    return {*value->number * unit.factor, productUnit(unit.base, hardUnit), " and @" + softScale};
}

std::vector<std::string> NanoscopeImage::notes() const {
    std::vector<std::string> notes;
    const NanoscopeLayout found = layout();
    if (found.isOfScan) {
        notes.push_back("the size in pixels is that of the scan list: the image's own does not fit "
                        "the length of its data");
    }
    if (found.size.rows < found.plannedRows) {
        notes.push_back("the scan was stopped after " + std::to_string(found.size.rows) + " of " +
                        std::to_string(found.plannedRows) + " lines");
    }
    const double pitchX = pixelPitch(found.sizeX, found.size.columns);
    const double pitchY = pixelPitch(found.sizeY, found.size.rows);
    if (pitchX > 0.0 && pitchY > 0.0 && std::abs(pitchX - pitchY) > 0.01 * pitchX) {
        notes.push_back("its pixels are not square: " + formatSi(pitchX, "m") + " x " +
                        formatSi(pitchY, "m") + ", by its scan size and aspect ratio");
    }
    if (std::string note = partNote(); !note.empty()) {
        notes.push_back(std::move(note));
    }
    const std::string* planefit = image_->find("Offline planefit");
    if (planefit != nullptr && !planefit->empty() && *planefit != "None") {
        notes.push_back("the heights were leveled before they were saved (" + *planefit + ")");
    }
    return notes;
}

int NanoscopeImage::bytesPerPixel() const {
    const long long bytes = image_->find("Bytes/pixel") == nullptr ? 2 : integer("Bytes/pixel");
    if (bytes != 1 && bytes != 2 && bytes != 4) {
        fail("'Bytes/pixel' is " + std::to_string(bytes) + "; expected 1, 2 or 4");
    }
    return static_cast<int>(bytes);
}

std::string NanoscopeImage::ofFile(const std::string& key) const {
    const std::string* const text = findIn(kNanoscopeFileLists, key);
    return text == nullptr ? std::string() : *text;
}

/// The oldest files have no version.
int NanoscopeImage::storedSampleBytes() const { return nanoscopeSampleBytes(ofFile("Version")); }

std::optional<double> NanoscopeImage::scanLength(const std::string& key) const {
    const std::string* text = findIn(kNanoscopeScanLists, key);
    const std::optional<LeadingNumber> number =
        text ? parseLeadingNumber(*text) : std::optional<LeadingNumber>();
    if (!number) {
        return std::nullopt;
    }
    const PhysicalUnit unit = parseUnit(number->rest);
    return unit.base == "m" ? std::optional(number->value * unit.factor) : std::nullopt;
}

std::optional<NanoscopePosition> NanoscopeImage::center(const NanoscopeLayout& layout) const {
    const std::optional<double> x = scanLength("X Offset");
    const std::optional<double> y = scanLength("Y Offset");
    if (!x && !y) {
        return std::nullopt;
    }
    const int missing = layout.plannedRows - layout.size.rows;
    return NanoscopePosition{x.value_or(0.0),
                             y.value_or(0.0) - 0.5 * missing * layout.sizeY / layout.size.rows};
}

std::string NanoscopeImage::partNote() const {
    constexpr double kRounding = 1e-3;
    const std::optional<ScanSize> own = scanSizeIn(image_->find("Scan size"));
    const std::optional<ScanSize> scan = scanSizeIn(findIn(kNanoscopeScanLists, "Scan size"));
    const bool hasCenter = scanLength("X Offset") || scanLength("Y Offset");
    if (!own || !scan || !hasCenter) {
        return {};
    }
    const auto isSmaller = [](double one, double other) {
        return std::abs(one) < (1.0 - kRounding) * std::abs(other);
    };
    // In a scan that is no square, y may be the larger side or its own.
    const bool isSquare = !isNonSquare(image_->find("Aspect ratio")) && !scanGrid().hasAspect;
    if (!isSmaller(own->x, scan->x) && !(isSquare && isSmaller(own->y, scan->y))) {
        return {};
    }
    return "it is a part of a scan of " + formatSi(std::abs(scan->x), "m") +
           ", and the file does not say which: its origin is that of the middle";
}

double NanoscopeImage::rotation() const {
    const std::string* const text = findIn(kNanoscopeScanLists, "Rotate Ang.");
    const std::optional<LeadingNumber> angle =
        text ? parseLeadingNumber(*text) : std::optional<LeadingNumber>();
    return angle ? angle->value : 0.0;
}

const std::string& NanoscopeImage::require(const std::string& key) const {
    const std::string* value = image_->find(key);
    if (value == nullptr) {
        fail("it has no '" + key + "'");
    }
    return *value;
}

long long NanoscopeImage::integer(const std::string& key) const {
    const std::string& text = require(key);
    const std::optional<long long> value = parseInteger(text);
    if (!value) {
        fail("'" + key + "': expected a whole number, found '" + text + "'");
    }
    return *value;
}

const std::string* NanoscopeImage::findIn(std::span<const std::string_view> sections,
                                          const std::string& key) const {
    for (const NanoscopeSection& candidate : *sections_) {
        if (!isNamed(candidate, sections)) {
            continue;
        }
        if (const std::string* value = candidate.find(key); value != nullptr) {
            return value;
        }
    }
    return nullptr;
}

const std::string* NanoscopeImage::findIn(NanoscopeList list, const std::string& key) const {
    switch (list) {
    case NanoscopeList::Scanner:
        return findIn(kNanoscopeScannerLists, key);
    case NanoscopeList::Scan:
        return findIn(kNanoscopeScanLists, key);
    case NanoscopeList::Controller:
        return findIn(kNanoscopeControllerLists, key);
    }
    return nullptr;
}

void NanoscopeImage::fail(const std::string& what) const { throw InputError(file_, list_, what); }

}  // namespace asperity
