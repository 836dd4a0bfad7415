#include "core/io/heightmap/nanoscope/OldScale.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

// Source: docs/formats.md 3.

namespace asperity {

namespace {

struct ListedFactor {
    NanoscopeList list;
    std::string_view key;  ///< empty: none
    bool divides = false;
};

/// What the scale of an image consists of that has none of its own.
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

}  // namespace asperity
