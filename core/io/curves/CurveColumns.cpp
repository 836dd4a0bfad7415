#include "core/io/curves/CurveColumns.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

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
constexpr std::array<std::string_view, 6> kSignals = {"signal",   "defl", "t-b",
                                                      "vertical", "dfl",  "photodiode"};
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

/// A quantity that a user can name, with the base of its units.
struct NamedQuantity {
    std::string_view name;
    CurveQuantity quantity;
    std::string_view unit;  ///< empty: it has none
};

constexpr std::array<NamedQuantity, 8> kNamed = {{{"base", CurveQuantity::Base, "m"},
                                                  {"separation", CurveQuantity::Separation, "m"},
                                                  {"indentation", CurveQuantity::Indentation, "m"},
                                                  {"deflection", CurveQuantity::Deflection, "m"},
                                                  {"force", CurveQuantity::Force, "N"},
                                                  {"signal", CurveQuantity::Voltage, "V"},
                                                  {"time", CurveQuantity::Time, "s"},
                                                  {"segment", CurveQuantity::Segment, ""}}};

[[noreturn]] void failColumn(std::string_view text, const std::string& expected) {
    throw Error("'" + std::string(text) + "' names no column: " + expected);
}

GivenColumn givenColumn(std::string_view text) {
    constexpr int kMaxColumns = 10'000;
    constexpr std::string_view kRetract = "retract-";
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) {
        failColumn(text, "expected QUANTITY=NUMBER:UNIT, such as base=1:um");
    }
    std::string_view name = trimmed(text.substr(0, equals));
    GivenColumn given;
    given.column.rank = 1;
    given.column.retract = name.starts_with(kRetract);
    name.remove_prefix(given.column.retract ? kRetract.size() : 0);
    const auto* const named = std::ranges::find(kNamed, name, &NamedQuantity::name);
    if (named == kNamed.end()) {
        failColumn(text, "expected base, separation, indentation, deflection, force, signal, time "
                         "or segment");
    }
    given.column.quantity = named->quantity;
    const std::string_view rest = text.substr(equals + 1);
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const std::optional<long long> number = parseInteger(rest.substr(0, colon));
    if (!number || *number < 1 || *number > kMaxColumns) {
        failColumn(text, "expected the number of the column, the first is 1");
    }
    given.number = static_cast<int>(*number);
    if (colon < rest.size()) {
        const PhysicalUnit unit = parseUnit(toUtf8(rest.substr(colon + 1)));
        if (unit.base != named->unit) {
            failColumn(text, named->unit.empty()
                                 ? "a segment has no unit"
                                 : "expected a unit of " + std::string(named->unit));
        }
        given.column.factor = unit.factor;
    }
    return given;
}

std::vector<std::string> cellsAt(std::string_view line, char separator) {
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

std::vector<std::string> cellsAtBlanks(std::string_view line) {
    std::vector<std::string> cells;
    constexpr std::string_view kBlanks = " \t";
    std::size_t begin = line.find_first_not_of(kBlanks);
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
        cells.emplace_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBlanks, end);
    }
    return cells;
}

bool areNumbers(const std::vector<std::string>& cells, const std::vector<int>& columns) {
    return std::ranges::all_of(columns, [&cells](int column) {
        return static_cast<std::size_t>(column) <= cells.size() &&
               cellNumber(cells[static_cast<std::size_t>(column) - 1]).has_value();
    });
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
        column.rank = holdsAny(name, kSignals) ? 2 : 1;
    } else if (title.unit.base == "N") {
        const bool plain = holds(name, "force") || holds(name, "load") || name == "f" ||
                           name == "fz" || name == "est_fz";
        column.quantity = CurveQuantity::Force;
        column.rank = plain ? 2 : 1;
    } else if (title.unit.base == "s" && holds(name, "time")) {
        column.quantity = CurveQuantity::Time;
        column.rank = 1;
    } else if (title.unit.base == "m") {
        takeLength(column, name);
    }
    return column;
}

std::vector<GivenColumn> givenColumns(std::string_view text) {
    std::vector<GivenColumn> columns;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        columns.push_back(givenColumn(trimmed(text.substr(0, comma))));
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    const auto names = [&columns](const std::vector<CurveQuantity>& quantities) {
        return std::ranges::any_of(columns, [&](const GivenColumn& each) {
            return std::ranges::count(quantities, each.column.quantity) > 0;
        });
    };
    if (!names({CurveQuantity::Base, CurveQuantity::Separation, CurveQuantity::Indentation})) {
        throw Error("the columns name no distance: base, separation or indentation is needed");
    }
    if (!names({CurveQuantity::Force, CurveQuantity::Deflection, CurveQuantity::Voltage})) {
        throw Error("the columns name nothing of the lever: force, deflection or signal is needed");
    }
    return columns;
}

std::vector<std::string> curveCells(std::string_view line) {
    return cellsAt(line, line.find('\t') != std::string_view::npos  ? '\t'
                         : line.find(';') != std::string_view::npos ? ';'
                                                                    : ',');
}

std::vector<std::string> curveCells(std::string_view line, const std::vector<int>& columns) {
    std::vector<std::string> cells = curveCells(line);
    if (!areNumbers(cells, columns)) {
        cells = cellsAtBlanks(line);
    }
    return areNumbers(cells, columns) ? cells : std::vector<std::string>();
}

std::optional<double> cellNumber(std::string_view cell) {
    if (cell.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (cell.find(',') == std::string_view::npos) {
        return parseNumber(cell);
    }
    std::string point(cell);
    std::replace(point.begin(), point.end(), ',', '.');  // no separator of cells can be left
    return parseNumber(point);
}

}  // namespace asperity
