#include "core/io/heightmap/text/TextHeader.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/NumberRow.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::string_view kSeparators = " \t,;";
/// Beyond it, a header without any numbers after it is none.
constexpr long long kMaxHeaderLines = 1000;
/// ESRI's own number for "no data" where a grid names none.
constexpr double kEsriNoData = -9999.0;

/// A column of points, "X[nm]" or "x (um)".
struct ColumnLabel {
    std::string name;
    std::string unit;
};

/// The label at the front of a text, which is taken off; empty when a bracket is not closed.
std::optional<ColumnLabel> takeLabel(std::string_view& text) {
    ColumnLabel label;
    const std::size_t end = std::min(text.find_first_of(" \t,;[("), text.size());
    label.name = text.substr(0, end);
    text = trimmed(text.substr(end));
    if (text.starts_with('[') || text.starts_with('(')) {
        const std::size_t close = text.find(text.front() == '[' ? ']' : ')');
        if (close == std::string_view::npos) {
            return std::nullopt;
        }
        label.unit = trimmed(text.substr(1, close - 1));
        text = text.substr(close + 1);
    }
    text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
    return label;
}

/// Labels of three columns, the first two called x and y.
std::optional<std::array<ColumnLabel, 3>> labelsOf(std::string_view text) {
    std::array<ColumnLabel, 3> labels;
    for (ColumnLabel& label : labels) {
        const std::optional<ColumnLabel> taken = takeLabel(text);
        if (!taken || taken->name.empty() || parseNumber(taken->name)) {
            return std::nullopt;
        }
        label = *taken;
    }
    const bool fits = text.empty() && lowerCase(labels[0].name).starts_with('x') &&
                      lowerCase(labels[1].name).starts_with('y');
    return fits ? std::optional(labels) : std::nullopt;
}

/// Returns whether a line that may be cut off begins with numbers.
/// @param isMatrix whether a size before it says that numbers follow, perhaps a single one
bool startsWithNumbers(std::string_view line, bool isMatrix) {
    constexpr std::size_t kLooked = 256;
    if (line.size() > kLooked) {
        const std::size_t end = line.find_last_of(kSeparators, kLooked);
        if (end == std::string_view::npos) {
            return false;
        }
        line = line.substr(0, end);
    }
    NumberRow row;
    readNumberRow(line, numberStyleOf(line), row);
    const bool hasNumber =
        std::ranges::any_of(row.numbers, [](double number) { return !std::isnan(number); });
    return row.wrong.empty() && (hasNumber || isMatrix || row.numbers.size() > 2);
}

class TextHeaderReader {
public:
    explicit TextHeaderReader(TextLines& lines) : lines_(lines) {}

    std::optional<TextHeader> read() {
        while (const std::optional<std::string_view> line = lines_.next()) {
            const std::string_view text = trimmed(*line);
            if (text.empty()) {
                continue;
            }
            if (startsWithNumbers(text, giveSize(comments_) || isSpip(assignments_) ||
                                            header_.isMatrix)) {
                header_.firstLine = *line;
                if (!giveSize(comments_) && isSpip(assignments_)) {
                    takeSpip(assignments_, lines_, header_);
                }
                takeComments(comments_, header_);
                takeGrid();
                return std::move(header_);
            }
            if (lines_.number() > kMaxHeaderLines || !takeLine(toUtf8(text))) {
                return std::nullopt;
            }
        }
        return std::nullopt;
    }

private:
    /// @return whether it belongs to a header
    bool takeLine(std::string_view line) {
        return takeComment(line) || takeWsxm(line) || takeLabels(line) || takeEsri(line) ||
               takeAssignment(line);
    }

    bool takeComment(std::string_view line) {
        if (!line.starts_with('#') && !line.starts_with('%') && !line.starts_with("//")) {
            return false;
        }
        line.remove_prefix(std::min(line.find_first_not_of("#%/"), line.size()));
        line = trimmed(line);
        if (takeLabels(line)) {
            return true;
        }
        const std::size_t colon = line.find(':');
        TextComment comment{.line = lines_.number()};
        if (const std::size_t equals = line.find('='); equals < colon) {
            comment.key = lowerCase(trimmed(line.substr(0, equals)));
            comment.value = trimmed(line.substr(equals + 1));
            assignments_.push_back(std::move(comment));
            return true;
        }
        if (colon != std::string_view::npos) {
            comment.key = trimmed(line.substr(0, colon));
            comment.value = trimmed(line.substr(colon + 1));
        }
        comments_.push_back(std::move(comment));
        return true;
    }

    bool takeWsxm(std::string_view line) {
        if (line.starts_with("WSxM file copyright") || line.starts_with("WSxM ASCII XYZ file")) {
            return true;
        }
        if (line.starts_with("WSxM ASCII Matrix file")) {
            isWsxmMatrix_ = header_.isMatrix = true;
            header_.lateralUnit = "m";
            return true;
        }
        const std::size_t colon = line.find(':');
        if (!isWsxmMatrix_ || colon == std::string_view::npos) {
            return false;
        }
        takeWsxmValue(std::string(trimmed(line.substr(0, colon))),
                      withDecimalPoint(std::string(trimmed(line.substr(colon + 1)))));
        return true;
    }

    void takeWsxmValue(const std::string& key, const std::string& value) {
        const std::optional<double> length = parseLength(value);
        const std::optional<LeadingNumber> number = parseLeadingNumber(value);
        if (key == "X Amplitude" && length) {
            header_.sizeX = *length;
            header_.sizeSource = location() + ", X Amplitude, Y Amplitude";
        } else if (key == "Y Amplitude" && length) {
            header_.sizeY = *length;
        } else if (key == "Z Amplitude" && number) {
            // Currents are of nA and pA; a bare A is WSxM's ångström, as of X and Y.
            const PhysicalUnit unit = parseLengthUnit(number->rest);
            header_.unit = unit.base == "a.u." ? PhysicalUnit{} : unit;
            header_.unitSource = location() + ", Z Amplitude";
        } else {
            header_.texts.set(key, value);
        }
    }

    bool takeLabels(std::string_view line) {
        const std::optional<std::array<ColumnLabel, 3>> labels = labelsOf(line);
        if (!labels) {
            return false;
        }
        for (std::size_t i = 0; i < labels->size(); ++i) {
            const ColumnLabel& label = (*labels)[i];
            const bool isLength = i < 2 || lowerCase(label.name).starts_with('z');
            // WSxM writes A for ångström.
            header_.pointUnits[i] = isLength ? parseLengthUnit(label.unit) : parseUnit(label.unit);
        }
        header_.title = (*labels)[2].name;
        header_.unitSource = location() + ", '" + std::string(line) + "'";
        return true;
    }

    bool takeEsri(std::string_view line) {
        const std::size_t blank = line.find_first_of(" \t");
        const std::string key = lowerCase(line.substr(0, blank));
        const bool isCount = key == "ncols" || key == "nrows";
        const bool known = isCount || (header_.isMatrix && std::ranges::count(kEsriKeys, key) > 0);
        if (!known || blank == std::string_view::npos) {
            return false;
        }
        const std::string value(trimmed(line.substr(blank)));
        const std::optional<double> number = parseNumber(value);
        if (!number) {
            lines_.fail("'" + key + "': expected a number, found '" + value + "'");
        }
        if (isCount) {
            (key == "ncols" ? header_.columns : header_.rows) = count(key, value);
        } else if (key == "nodata_value") {
            header_.noData = *number;
        } else {
            header_.texts.set(key, value);
        }
        if (!header_.noData) {
            header_.noData = kEsriNoData;
        }
        header_.isMatrix = isEsri_ = true;
        return true;
    }

    [[nodiscard]] std::optional<double> gridNumber(const std::string& key) const {
        const auto found = header_.texts.all().find(key);
        return found == header_.texts.all().end() ? std::nullopt : parseNumber(found->second);
    }

    /// Returns the keys that give the sides of a cell.
    static std::string sideKeys(bool hasX, bool hasY) {
        if (hasX == hasY) {
            return hasX ? "dx, dy" : "cellsize";
        }
        return hasX ? "dx, cellsize" : "cellsize, dy";
    }

    /// Takes size and corner of an ESRI grid. They have no unit: meters, where a scan may be as
    /// large as that.
    void takeGrid() {
        constexpr double kMaxScan = 1e-3;  // [m]
        if (!isEsri_) {
            return;
        }
        const std::optional<double> cell = gridNumber("cellsize");
        const std::optional<double> dx = gridNumber("dx");
        const std::optional<double> dy = gridNumber("dy");
        if (!cell && dx.has_value() != dy.has_value()) {
            header_.notes.emplace_back(dx ? "it gives dx without dy; its size is not known"
                                          : "it gives dy without dx; its size is not known");
        }
        const double cellX = dx.value_or(cell.value_or(0.0));
        const double cellY = dy.value_or(cell.value_or(0.0));
        const double sizeX = cellX * static_cast<double>(header_.columns);
        const double sizeY = cellY * static_cast<double>(header_.rows);
        if (!(sizeX > 0.0 && sizeY > 0.0)) {
            return;
        }
        if (sizeX > kMaxScan || sizeY > kMaxScan) {
            header_.notes.push_back("its cells have sides of " + exactText(cellX) + " and " +
                                    exactText(cellY) + " without a unit, too large for meters");
            return;
        }
        const auto corner = [this](char axis, double pitch) {
            const std::string start = axis + std::string("ll");
            const std::optional<double> center = gridNumber(start + "center");
            return center ? *center - 0.5 * pitch : gridNumber(start + "corner").value_or(0.0);
        };
        header_.sizeX = sizeX;
        header_.sizeY = sizeY;
        header_.originX = corner('x', cellX);
        header_.originY = corner('y', cellY);
        header_.lateralUnit = "m";
        header_.sizeSource = sideKeys(dx.has_value(), dy.has_value());
        header_.notes.push_back(header_.sizeSource +
                                " and corner have no unit; meters are assumed");
    }

    /// "h=305 w=75", and after it "pixel size=3.7e-007 m" and others.
    bool takeAssignment(std::string_view line) {
        if (line.starts_with("h=") || line.starts_with("w=")) {
            return takeCounts(line);
        }
        const std::size_t equals = line.find('=');
        if (!header_.isMatrix || equals == std::string_view::npos) {
            return false;
        }
        takeValue(std::string(trimmed(line.substr(0, equals))),
                  std::string(trimmed(line.substr(equals + 1))));
        return true;
    }

    bool takeCounts(std::string_view line) {
        while (!line.empty()) {
            const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
            const std::string word(line.substr(0, end));
            line = trimmed(line.substr(end));
            if (!word.starts_with("h=") && !word.starts_with("w=")) {
                return false;
            }
            (word[0] == 'h' ? header_.rows : header_.columns) =
                count(word.substr(0, 1), word.substr(2));
        }
        header_.isMatrix = true;
        return true;
    }

    void takeValue(const std::string& key, const std::string& value) {
        const std::optional<LeadingNumber> number = parseLeadingNumber(value);
        if (key == "pixel size" && number) {
            const PhysicalUnit unit = parseUnit(number->rest);
            header_.pitch = number->value * unit.factor;
            header_.lateralUnit = unit.base;
            header_.sizeSource = location() + ", pixel size";
        } else if (key.starts_with(kFactorKey) && key.ends_with(')') && number) {
            header_.unit =
                parseUnit(key.substr(kFactorKey.size(), key.size() - kFactorKey.size() - 1));
            header_.unit.factor *= number->value;
            header_.unitSource = location() + ", height conversion factor";
        } else {
            header_.texts.set(key, value);
            if (key == "data unit" && header_.unit.base.empty()) {
                header_.unit = parseUnit(value);
                header_.unitSource = location() + ", data unit";
            }
        }
    }

    [[nodiscard]] long long count(const std::string& key, const std::string& text) const {
        const std::optional<long long> number = parseInteger(text);
        if (!number || *number < 1) {
            lines_.fail("'" + key + "': expected a whole number of 1 or more, found '" + text +
                        "'");
        }
        return *number;
    }

    [[nodiscard]] std::string location() const { return "line " + std::to_string(lines_.number()); }

    static constexpr std::string_view kFactorKey = "height conversion factor (->";
    /// After the counts.
    static constexpr std::array<std::string_view, 8> kEsriKeys = {
        "xllcorner", "yllcorner", "xllcenter", "yllcenter", "dx", "dy", "cellsize", "nodata_value"};

    TextLines& lines_;
    TextHeader header_;
    std::vector<TextComment> comments_;
    std::vector<TextComment> assignments_;  ///< comments of the form "key = value"; lower-case keys
    bool isWsxmMatrix_ = false;
    bool isEsri_ = false;
};

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

/// Indices of the comments with width and height.
struct SizeIndices {
    std::size_t width = 0;
    std::size_t height = 0;
};

bool holdsNumber(const TextComment& comment) {
    return parseLeadingNumber(comment.value).has_value();
}

/// Returns whether a comment may be the unit of the values, "# Einheit: nm".
bool mayBeUnit(const TextComment& comment) {
    return !comment.value.empty() && !holdsNumber(comment) &&
           comment.value.find_first_of(" \t") == std::string::npos;
}

std::optional<SizeIndices> indicesOfSize(const std::vector<TextComment>& comments) {
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
        return SizeIndices{*width, *height};
    }
    // Words in a language that is not known here: as Gwyddion orders them.
    const bool areOrdered = lengths.size() == 2 && lengths[1] == lengths[0] + 1 &&
                            lengths[1] + 1 < comments.size() && mayBeUnit(comments[lengths[1] + 1]);
    if (areOrdered) {
        return SizeIndices{lengths[0], lengths[1]};
    }
    return std::nullopt;
}

std::string locationOf(const TextComment& comment) {
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
    header.sizeSource = locationOf(width) + "; " + locationOf(height);
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

std::optional<TextHeader> readTextHeader(TextLines& lines) {
    return TextHeaderReader(lines).read();
}

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
        header.unitSource = locationOf(*unit);
    } else if (const TextComment* const step = find(assignments, "bit2nm")) {
        header.unit = {spipNumber(*step, lines) * kSpipLength, "m"};
        header.unitSource = locationOf(*step);
    }
    for (const TextComment& each : assignments) {
        header.texts.set(each.key, each.value);
    }
}

bool giveSize(const std::vector<TextComment>& comments) {
    return indicesOfSize(comments).has_value();
}

void takeComments(const std::vector<TextComment>& comments, TextHeader& header) {
    const std::optional<SizeIndices> found = indicesOfSize(comments);
    std::vector<bool> used(comments.size(), false);
    if (found) {
        takeSize(comments[found->width], comments[found->height], header);
        used[found->width] = used[found->height] = true;
        const std::size_t before = found->width - 1;  // beyond the end where there is none
        if (before < comments.size()) {
            header.title = comments[before].value;
            used[before] = true;
        }
        const std::size_t after = found->height + 1;
        if (after < comments.size() && !holdsNumber(comments[after])) {
            header.unit = parseUnit(comments[after].value);
            header.unitSource = locationOf(comments[after]);
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
