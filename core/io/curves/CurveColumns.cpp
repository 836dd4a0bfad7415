#include "core/io/curves/CurveColumns.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

/// A title without its unit, in lower case.
struct Title {
    std::string name;
    PhysicalUnit unit;
};

/// "Force (nN)", "Force [nN]": in the last brackets; "force_nN": behind the last underscore.
Title titleOf(std::string_view text) {
    const std::string title = toUtf8(trimmed(text));
    for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
        const std::size_t begin = title.rfind(open);
        const std::size_t end = title.rfind(close);
        if (begin != std::string::npos && end != std::string::npos && begin < end) {
            return {lowerCase(trimmed(title.substr(0, begin))),
                    parseUnit(trimmed(title.substr(begin + 1, end - begin - 1)))};
        }
    }
    const std::size_t split = title.rfind('_');
    if (split == std::string::npos) {
        return {lowerCase(title), {}};
    }
    std::string unit = title.substr(split + 1);
    if (unit == "n") {  // as in our own tables
        unit = "N";
    }
    return {lowerCase(title.substr(0, split)), parseUnit(unit)};
}

bool holds(const std::string& name, std::string_view part) {
    return name.find(part) != std::string::npos;
}

template <std::size_t kCount>
bool holdsAny(const std::string& name, const std::array<std::string_view, kCount>& parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&name](std::string_view part) { return holds(name, part); });
}

constexpr std::array<std::string_view, 4> kSeparations = {"separation", "gap", "distance", "sep"};
constexpr std::array<std::string_view, 3> kDeflections = {"deflection", "defl", "cantilever"};
constexpr std::array<std::string_view, 8> kBases = {"base", "piezo",     "z-sens",       "height",
                                                    "ramp", "extension", "displacement", "zsens"};
constexpr std::array<std::string_view, 3> kRetracts = {"retract", "unload", "backward"};

void takeLength(CurveColumn& column, const std::string& name) {
    const auto is = [&column](CurveQuantity quantity, int rank) {
        column.quantity = quantity;
        column.rank = rank;
    };
    if (name == "base_x" || name == "base_y" || name == "x" || name == "y") {
        return;
    }
    if (holds(name, "indentation")) {
        is(CurveQuantity::Indentation, 1);
    } else if (holdsAny(name, kDeflections)) {
        is(CurveQuantity::Deflection, 1);
    } else if (holdsAny(name, kSeparations)) {
        is(CurveQuantity::Separation, 1);
    } else if (holdsAny(name, kBases) || name == "z" || name.ends_with(" z")) {
        is(CurveQuantity::Base, 1);
    }
}

}  // namespace

CurveColumn curveColumn(std::string_view text) {
    const Title title = titleOf(text);
    CurveColumn column{.factor = title.unit.factor};
    const std::string name = title.name;
    column.retract = holdsAny(name, kRetracts);
    if (name == "segment" || name == "branch") {
        column.quantity = CurveQuantity::Segment;
    } else if (title.unit.base == "V") {
        column.quantity = CurveQuantity::Voltage;
    } else if (title.unit.base == "N") {
        const bool plain = holds(name, "force") || holds(name, "load") || name == "f" ||
                           name == "fz" || name == "est_fz";
        column.quantity = CurveQuantity::Force;
        column.rank = plain ? 2 : 1;
    } else if (title.unit.base == "m") {
        takeLength(column, name);
    }
    return column;
}

std::vector<std::string> curveCells(std::string_view line) {
    const char separator = line.find('\t') != std::string_view::npos  ? '\t'
                           : line.find(';') != std::string_view::npos ? ';'
                                                                      : ',';
    std::vector<std::string> cells;
    std::size_t begin = 0;
    while (begin <= line.size()) {
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        std::string_view cell = trimmed(line.substr(begin, end - begin));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
            cell = cell.substr(1, cell.size() - 2);
        }
        cells.emplace_back(cell);
        begin = end + 1;
    }
    return cells;
}

}  // namespace asperity
