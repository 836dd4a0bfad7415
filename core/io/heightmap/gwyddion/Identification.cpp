#include "core/io/heightmap/gwyddion/Identification.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

/// The formats of Gwyddion's module for pictures.
constexpr std::array<std::string_view, 14> kPictures{"bmp",      "gif",  "heif", "icns", "jpeg",
                                                     "jpeg2000", "pcx",  "png",  "pnm",  "ras",
                                                     "tga",      "tiff", "webp", "xpm"};

/// The rest of the first line that begins so; empty when none does.
std::string_view lineAfter(std::string_view text, std::string_view beginning) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        if (line.starts_with(beginning)) {
            return trimmed(line.substr(beginning.size()));
        }
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return {};
}

}  // namespace

bool Identification::isPicture() const { return std::ranges::count(kPictures, module) > 0; }

std::optional<Identification> identificationIn(std::string_view output, std::string_view file) {
    const std::string_view found = lineAfter(output, std::string(file) + ": ");
    const std::size_t bracket = found.rfind('[');
    const std::size_t comma = found.rfind(',');
    if (bracket == std::string_view::npos || comma == std::string_view::npos || comma < bracket ||
        !found.ends_with(']')) {
        return std::nullopt;
    }
    const std::optional<long long> score =
        parseInteger(trimmed(found.substr(comma + 1, found.size() - comma - 2)));
    if (!score || *score < 0 || *score > 1000) {
        return std::nullopt;
    }
    return Identification{.name = toUtf8(trimmed(found.substr(0, bracket))),
                          .module = toUtf8(trimmed(found.substr(bracket + 1, comma - bracket - 1))),
                          .score = static_cast<int>(*score)};
}

std::string versionIn(std::string_view output) {
    const std::string_view found = lineAfter(output, "Gwyddion ");
    return toUtf8(found.substr(0, found.find(' ')));
}

}  // namespace asperity
