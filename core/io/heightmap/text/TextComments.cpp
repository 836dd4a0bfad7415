#include "core/io/heightmap/text/TextComments.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Needed only where more than two comments hold a length. In lower case but for letters that are
/// not ASCII.
constexpr std::array<std::string_view, 5> kWidthWords = {"width", "breite", "largeur", "šířka",
                                                         "Šířka"};
constexpr std::array<std::string_view, 5> kHeightWords = {"height", "höhe", "hauteur", "výška",
                                                          "Výška"};

struct Length {
    double value = 0.0;
    std::string unit;  ///< SI base unit
};

/// A number and one word after it, "10.00 µm".
std::optional<Length> lengthOf(const TextComment& comment) {
    const std::string value = withDecimalPoint(comment.value);
    const std::optional<LeadingNumber> number = parseLeadingNumber(value);
    const bool fits = number && std::isfinite(number->value) && !number->rest.empty() &&
                      number->rest.find_first_of(" \t") == std::string_view::npos;
    if (!fits) {
        return std::nullopt;
    }
    const PhysicalUnit unit = parseUnit(number->rest);
    return Length{number->value * unit.factor, unit.base};
}

/// Where the width stands and where the height does; empty when it cannot be told.
struct SizePlaces {
    std::size_t width = 0;
    std::size_t height = 0;
};

bool holdsNumber(const TextComment& comment) {
    return parseLeadingNumber(comment.value).has_value();
}

/// Whether a comment may be the unit of the values, "# Einheit: nm".
bool mayBeUnit(const TextComment& comment) {
    return !comment.value.empty() && !holdsNumber(comment) &&
           comment.value.find_first_of(" \t") == std::string::npos;
}

std::optional<SizePlaces> placesOfSize(const std::vector<TextComment>& comments) {
    std::vector<std::size_t> lengths;
    std::optional<std::size_t> width;
    std::optional<std::size_t> height;
    for (std::size_t i = 0; i < comments.size(); ++i) {
        if (!lengthOf(comments[i])) {
            continue;
        }
        const std::string key = lowerCase(comments[i].key);
        lengths.push_back(i);
        if (!width && std::ranges::count(kWidthWords, key) > 0) {
            width = i;
        }
        if (!height && std::ranges::count(kHeightWords, key) > 0) {
            height = i;
        }
    }
    if (width && height) {
        return SizePlaces{*width, *height};
    }
    // Words in a language that is not known here: as Gwyddion orders them.
    const bool areOrdered = lengths.size() == 2 && lengths[1] == lengths[0] + 1 &&
                            lengths[1] + 1 < comments.size() && mayBeUnit(comments[lengths[1] + 1]);
    if (areOrdered) {
        return SizePlaces{lengths[0], lengths[1]};
    }
    return std::nullopt;
}

std::string placeOf(const TextComment& comment) {
    return "line " + std::to_string(comment.line) + ", " + comment.key;
}

void takeSize(const TextComment& width, const TextComment& height, TextHeader& header) {
    const Length x = *lengthOf(width);
    const Length y = *lengthOf(height);
    header.isMatrix = true;
    if (x.unit != y.unit) {
        header.notes.push_back("width and height have different units ('" + width.value +
                               "' and '" + height.value + "')");
        return;
    }
    header.sizeX = x.value;
    header.sizeY = y.value;
    header.lateralUnit = x.unit;
    header.sizeSource = placeOf(width) + "; " + placeOf(height);
}

constexpr double kSpipLength = 1e-9;  ///< SPIP's lengths are in nm [m]

/// Null when there is none.
const TextComment* find(const std::vector<TextComment>& comments, std::string_view key) {
    const auto found = std::ranges::find(comments, key, &TextComment::key);
    return found == comments.end() ? nullptr : &*found;
}

/// @throw InputError when the value is no number
double spipNumber(const TextComment& comment, const TextLines& lines) {
    const std::string value = withDecimalPoint(comment.value);
    const std::optional<double> number = parseNumber(value);
    if (!number || !std::isfinite(*number)) {
        lines.fail("'" + comment.key + "' of line " + std::to_string(comment.line) +
                   ": expected a number, found '" + comment.value + "'");
    }
    return *number;
}

long long spipCount(const TextComment& comment, const TextLines& lines) {
    const std::optional<long long> count = parseInteger(comment.value);
    if (!count || *count < 1) {
        lines.fail("'" + comment.key + "' of line " + std::to_string(comment.line) +
                   ": expected a whole number of 1 or more, found '" + comment.value + "'");
    }
    return *count;
}

/// @return whether the comment is part of the origin
bool takeOrigin(const TextComment& comment, TextHeader& header) {
    const bool isX = comment.key == kOriginXComment;
    if (!isX && comment.key != kOriginYComment) {
        return false;
    }
    const std::optional<Length> length = lengthOf(comment);
    if (!length || length->unit != header.lateralUnit) {
        return false;
    }
    (isX ? header.originX : header.originY) = length->value;
    return true;
}

}  // namespace

std::string withDecimalPoint(std::string text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) {
        return text;
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789", comma + 1), text.size());
    const std::size_t digits = end - comma - 1;
    if (digits > 0 && digits != 3 && text.find_first_of(".,", comma + 1) == std::string::npos) {
        text[comma] = '.';
    }
    return text;
}

bool isSpip(const std::vector<TextComment>& assignments) {
    const TextComment* const format = find(assignments, "file format");
    return format != nullptr && lowerCase(format->value) == "ascii" &&
           find(assignments, "x-pixels") != nullptr && find(assignments, "y-pixels") != nullptr;
}

void takeSpip(const std::vector<TextComment>& assignments, const TextLines& lines,
              TextHeader& header) {
    const auto number = [&](const char* key) {
        const TextComment* const found = find(assignments, key);
        return found == nullptr ? 0.0 : spipNumber(*found, lines);
    };
    header.isMatrix = true;
    header.columns = spipCount(*find(assignments, "x-pixels"), lines);
    header.rows = spipCount(*find(assignments, "y-pixels"), lines);
    header.sizeX = number("x-length") * kSpipLength;
    header.sizeY = number("y-length") * kSpipLength;
    header.originX = number("x-offset") * kSpipLength;
    header.originY = number("y-offset") * kSpipLength;
    header.lateralUnit = "m";
    header.sizeSource = "x-length and y-length, in nm";
    header.hasMask = number("voidpixels") != 0.0;
    if (const TextComment* const unit = find(assignments, "z-unit")) {
        header.unit = parseUnit(unit->value);
        header.unitSource = placeOf(*unit);
    } else if (const TextComment* const step = find(assignments, "bit2nm")) {
        header.unit = {spipNumber(*step, lines) * kSpipLength, "m"};
        header.unitSource = placeOf(*step);
    }
    for (const TextComment& each : assignments) {
        header.texts.set(each.key, each.value);
    }
}

bool giveSize(const std::vector<TextComment>& comments) {
    return placesOfSize(comments).has_value();
}

void takeComments(const std::vector<TextComment>& comments, TextHeader& header) {
    const std::optional<SizePlaces> places = placesOfSize(comments);
    std::vector<bool> used(comments.size(), false);
    if (places) {
        takeSize(comments[places->width], comments[places->height], header);
        used[places->width] = used[places->height] = true;
        const std::size_t before = places->width - 1;  // beyond the end where there is none
        if (before < comments.size()) {
            header.title = comments[before].value;
            used[before] = true;
        }
        const std::size_t after = places->height + 1;
        if (after < comments.size() && !holdsNumber(comments[after])) {
            header.unit = parseUnit(comments[after].value);
            header.unitSource = placeOf(comments[after]);
            used[after] = true;
        }
    }
    for (std::size_t i = 0; i < comments.size(); ++i) {
        if (!used[i] && !comments[i].key.empty() && !takeOrigin(comments[i], header)) {
            header.texts.set(comments[i].key, comments[i].value);
        }
    }
}

}  // namespace asperity
