#include "core/io/heightmap/igor/AsylumChannel.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

// Channels of Asylum Research instruments. Source: docs/formats.md 6.

namespace asperity {

namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 8> kAsylumUnits{
    {{"Height", "m"},
     {"ZSensor", "m"},
     {"Deflection", "m"},
     {"Amplitude", "m"},
     {"Phase", "deg"},
     {"Current", "A"},
     {"Frequency", "Hz"},
     {"Potential", "V"}}};

/// "HeightTraceMod1" → "HeightTrace": images that were changed after the scan.
std::string_view withoutChanges(std::string_view label) {
    const std::size_t mark = label.rfind("Mod");
    const bool numbered = mark != std::string_view::npos && mark > 0 && mark + 3 < label.size() &&
                          label.find_first_not_of("0123456789", mark + 3) == std::string_view::npos;
    return numbered ? label.substr(0, mark) : label;
}

/// "NapPotentialRetrace" → "Potential"
std::string signalOf(std::string_view label) {
    label = withoutChanges(label);
    for (const std::string_view direction : {"Retrace", "Trace"}) {
        if (label.ends_with(direction)) {
            label.remove_suffix(direction.size());
            break;
        }
    }
    if (label.starts_with("Nap")) {
        label.remove_prefix(3);
    }
    return std::string(label);
}

}  // namespace

std::map<std::string, std::string> parseAsylumNote(const std::string& note) {
    std::map<std::string, std::string> fields;
    for (const std::string_view line : linesOf(note)) {
        const std::size_t colon = line.find(':');
        if (colon != std::string_view::npos && colon > 0) {
            fields.emplace(toUtf8(trimmed(line.substr(0, colon))),
                           toUtf8(trimmed(line.substr(colon + 1))));
        }
    }
    return fields;
}

bool isAsylumLabel(const std::string& label) {
    const std::string_view image = withoutChanges(label);
    return image.ends_with("Trace") || image.ends_with("Retrace");
}

std::string asylumUnit(const std::string& label, const std::map<std::string, std::string>& note) {
    const std::string signal = signalOf(label);
    const auto said = note.find(signal + "Unit");
    if (said != note.end()) {
        return said->second;
    }
    for (const auto& [name, unit] : kAsylumUnits) {
        if (signal.starts_with(name)) {
            return unit;
        }
    }
    return {};
}

}  // namespace asperity
