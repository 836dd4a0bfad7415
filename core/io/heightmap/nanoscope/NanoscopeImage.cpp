#include "core/io/heightmap/nanoscope/NanoscopeImage.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// From this version on samples have 32 bits, whatever "Bytes/pixel" says.
constexpr unsigned kFirstWideVersion = 0x09200000;

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

/// One or two numbers and their unit, "84.8 84.8 ~m" or "2000 nm".
struct ScanSize {
    double x = 0.0;  ///< [m]
    double y = 0.0;  ///< [m]
    bool hasY = false;
};

std::optional<ScanSize> parseScanSize(std::string_view text) {
    const std::optional<LeadingNumber> x = parseLeadingNumber(text);
    if (!x) {
        return std::nullopt;
    }
    const std::optional<LeadingNumber> y = parseLeadingNumber(x->rest);
    const PhysicalUnit unit = parseUnit(y ? y->rest : x->rest);
    if (unit.base != "m") {
        return std::nullopt;
    }
    return ScanSize{x->value * unit.factor, (y ? y->value : x->value) * unit.factor, y.has_value()};
}

/// x over y of "4:1" or "0.512"; 1 when it says nothing sensible.
double parseAspectRatio(const std::string* text) {
    if (text == nullptr) {
        return 1.0;
    }
    const std::size_t colon = text->find(':');
    const std::optional<double> x = parseNumber(text->substr(0, colon));
    const std::optional<double> y =
        colon == std::string::npos ? 1.0 : parseNumber(text->substr(colon + 1));
    const double ratio = x && y ? *x / *y : 1.0;
    return std::isfinite(ratio) && ratio > 0.0 ? ratio : 1.0;
}

}  // namespace

NanoscopeImage::NanoscopeImage(const std::vector<NanoscopeSection>& sections,
                               const NanoscopeSection& image, std::string file, std::string place)
    : sections_(&sections), image_(&image), file_(std::move(file)), place_(std::move(place)) {}

std::string NanoscopeImage::name() const {
    const std::string* entry = image_->find("@2:Image Data");
    const std::optional<CiaoValue> value = entry ? parseCiaoValue(*entry) : std::nullopt;
    if (!value) {
        return place_;
    }
    if (!value->bracket.empty()) {
        return value->bracket;
    }
    return value->text.empty() ? place_ : value->text;
}

std::string NanoscopeImage::direction() const {
    const std::string* entry = image_->find("Line direction");
    return entry ? directionFromName(*entry) : std::string();
}

NanoscopeLayout NanoscopeImage::layout() const {
    const ImageSize planned = checkedImageSize(integer("Samps/line"), integer("Number of lines"),
                                               file_, place_ + ": Samps/line, Number of lines");
    NanoscopeLayout layout;
    layout.plannedRows = planned.rows;
    layout.sampleBytes = storedSampleBytes();
    const long long offset = integer("Data offset");
    const long long length = integer("Data length");
    const long long rowBytes = static_cast<long long>(planned.columns) * layout.sampleBytes;
    const bool fits =
        offset > 0 && length > 0 && length % rowBytes == 0 && length / rowBytes <= planned.rows;
    if (!fits) {
        fail("'Data offset' " + std::to_string(offset) + " and 'Data length' " +
             std::to_string(length) + " do not fit " + std::to_string(planned.columns) + " x " +
             std::to_string(planned.rows) + " samples of " + std::to_string(layout.sampleBytes) +
             " bytes");
    }
    layout.offset = static_cast<std::uint64_t>(offset);
    layout.size = {planned.columns, static_cast<int>(length / rowBytes)};
    readScanSize(layout);
    return layout;
}

void NanoscopeImage::readScanSize(NanoscopeLayout& layout) const {
    const std::string* text = image_->find("Scan size");
    if (text == nullptr) {
        text = findIn("Ciao scan list", "Scan size");
    }
    const std::optional<ScanSize> size = text ? parseScanSize(*text) : std::nullopt;
    if (!size) {
        fail("expected 'Scan size' with one or two numbers and a unit of length");
    }
    const double ratio = size->hasY ? 1.0 : parseAspectRatio(image_->find("Aspect ratio"));
    layout.sizeX = size->x;
    layout.sizeY = size->y / ratio * layout.size.rows / layout.plannedRows;
}

NanoscopeScale NanoscopeImage::scale() const {
    const std::string* entry = image_->find("@2:Z scale");
    if (entry == nullptr) {
        fail(
            "it has no '@2:Z scale'; files of NanoScope before version 4.3 cannot be read, convert "
            "them with Gwyddion");
    }
    const std::optional<CiaoValue> value = parseCiaoValue(*entry);
    if (!value || !value->number) {
        fail("'@2:Z scale': expected 'V [..] (..) number unit', found '" + *entry + "'");
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
    scale.source = place_ + ", @2:Z scale" + scale.source;
    scale.factor *= *value->number * (keepsUnit ? 1.0 : hard.factor) / fullScale;
    return scale;
}

NanoscopeScale NanoscopeImage::sensitivity(const std::string& softScale,
                                           const std::string& hardUnit) const {
    if (softScale.empty()) {
        return {1.0, hardUnit, ""};
    }
    const std::string* entry = findIn("Scanner list", "@" + softScale);
    if (entry == nullptr) {
        entry = findIn("Ciao scan list", "@" + softScale);
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
    if (found.size.rows < found.plannedRows) {
        notes.push_back("the scan was stopped after " + std::to_string(found.size.rows) + " of " +
                        std::to_string(found.plannedRows) + " lines");
    }
    const double ratio = parseAspectRatio(image_->find("Aspect ratio"));
    const double stated = found.sizeX / found.sizeY;
    if (std::abs(ratio - stated) > 0.01 * stated) {
        notes.emplace_back("the aspect ratio disagrees with the scan size, which is used");
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

std::string NanoscopeImage::version() const {
    const std::string* text = findIn("File list", "Version");
    if (text == nullptr) {
        text = findIn("Force file list", "Version");
    }
    return text == nullptr ? std::string() : *text;
}

int NanoscopeImage::storedSampleBytes() const {
    const std::string text = version();
    unsigned version = 0;
    const char* const end = text.data() + text.size();
    if (!text.starts_with("0x") || std::from_chars(text.data() + 2, end, version, 16).ptr != end) {
        throw InputError(file_, "File list", "expected 'Version' with a number like 0x09010201");
    }
    return version >= kFirstWideVersion ? 4 : 2;
}

double NanoscopeImage::scanLength(const std::string& key) const {
    const std::string* text = findIn("Ciao scan list", key);
    const std::optional<LeadingNumber> number =
        text ? parseLeadingNumber(*text) : std::optional<LeadingNumber>();
    if (!number) {
        return 0.0;
    }
    const PhysicalUnit unit = parseUnit(number->rest);
    return unit.base == "m" ? finiteOrZero(number->value * unit.factor) : 0.0;
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

const std::string* NanoscopeImage::findIn(const std::string& section,
                                          const std::string& key) const {
    for (const NanoscopeSection& candidate : *sections_) {
        if (lowerCase(candidate.name) != lowerCase(section)) {
            continue;
        }
        if (const std::string* value = candidate.find(key); value != nullptr) {
            return value;
        }
    }
    return nullptr;
}

void NanoscopeImage::fail(const std::string& what) const { throw InputError(file_, place_, what); }

}  // namespace asperity
