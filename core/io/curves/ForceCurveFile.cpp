#include "core/io/curves/ForceCurveFile.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr std::size_t kMaxPoints = 20'000'000;

/// Columns of one branch; -1: there is none.
struct BranchColumns {
    int distance = -1;
    int deflection = -1;
    int force = -1;
};

/// Facts from the line of titles.
struct CurveTable {
    std::vector<CurveColumn> columns;
    BranchColumns first;   ///< of all rows, or of the approach
    BranchColumns second;  ///< of the retract, where it has columns of its own
    int segment = -1;

    [[nodiscard]] const CurveColumn& at(int column) const {
        return columns[static_cast<std::size_t>(column)];
    }
};

/// The column of the highest rank with this quantity; -1: none.
int find(const std::vector<CurveColumn>& columns, CurveQuantity quantity, bool retract) {
    int found = -1;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool counts = columns[i].quantity == quantity && columns[i].retract == retract;
        if (counts &&
            (found < 0 || columns[i].rank > columns[static_cast<std::size_t>(found)].rank)) {
            found = static_cast<int>(i);
        }
    }
    return found;
}

BranchColumns branchColumns(const std::vector<CurveColumn>& columns, bool retract) {
    BranchColumns branch;
    for (const CurveQuantity quantity :
         {CurveQuantity::Base, CurveQuantity::Separation, CurveQuantity::Indentation}) {
        if (branch.distance < 0) {
            branch.distance = find(columns, quantity, retract);
        }
    }
    branch.deflection = find(columns, CurveQuantity::Deflection, retract);
    branch.force = find(columns, CurveQuantity::Force, retract);
    return branch;
}

bool isWhole(const BranchColumns& branch) { return branch.distance >= 0 && branch.force >= 0; }

/// Returns none where the line names no distance and force.
std::optional<CurveTable> tableOf(const std::vector<std::string>& titles) {
    CurveTable table;
    for (const std::string& title : titles) {
        table.columns.push_back(curveColumn(title));
    }
    table.first = branchColumns(table.columns, false);
    table.second = branchColumns(table.columns, true);
    table.segment = find(table.columns, CurveQuantity::Segment, false);
    return isWhole(table.first) ? std::optional(table) : std::nullopt;
}

bool namesVoltages(const std::vector<std::string>& titles) {
    bool distance = false;
    bool voltage = false;
    for (const std::string& title : titles) {
        const CurveQuantity quantity = curveColumn(title).quantity;
        distance = distance || quantity == CurveQuantity::Base ||
                   quantity == CurveQuantity::Separation || quantity == CurveQuantity::Indentation;
        voltage = voltage || quantity == CurveQuantity::Voltage;
    }
    return distance && voltage;
}

/// "k (N/m)<tab>0.019": the spring constant; 0: the line says none. Nothing says in a line
/// "Force Constant, nN/nm:" whether it was ever calibrated: that one is not taken.
double stiffnessIn(const std::vector<std::string>& cells) {
    if (cells.size() < 2 || !lowerCase(cells[0]).starts_with("k (")) {
        return 0.0;
    }
    const std::optional<double> value = parseNumber(cells[1]);
    const bool isInNewtons = cells[0].find("(N/m)") != std::string::npos;
    return value && isInNewtons && *value > 0.0 && std::isfinite(*value) ? *value : 0.0;
}

CurveSegmentKind kindOf(const std::string& text, TextLines& lines) {
    const std::string name = lowerCase(text);
    const auto says = [&name](const char* word) { return name.find(word) != std::string::npos; };
    if (says("approach") || says("extend")) {
        return CurveSegmentKind::Approach;
    }
    if (says("retract")) {
        return CurveSegmentKind::Retract;
    }
    if (says("pause") || says("dwell") || says("modulation")) {
        return CurveSegmentKind::Pause;
    }
    lines.fail("'" + text + "' is no segment: approach, pause or retract is");
}

/// Reads the rows below the titles.
class RowReader {
public:
    RowReader(const CurveTable& table, TextLines& lines) : table_(table), lines_(lines) {}

    void take(std::string_view line) {
        std::vector<std::string> cells = curveCells(line);
        cells.resize(std::max(cells.size(), table_.columns.size()));
        if (table_.segment >= 0) {
            startSegment(cells[static_cast<std::size_t>(table_.segment)]);
        } else if (segments_.empty()) {
            segments_.emplace_back();
        }
        add(table_.first, cells, segments_.back());
        if (isWhole(table_.second)) {
            add(table_.second, cells, retract_);
        }
    }

    [[nodiscard]] std::vector<CurveSegment> finish() {
        if (!retract_.force.empty()) {
            retract_.kind = CurveSegmentKind::Retract;
            segments_.push_back(std::move(retract_));
        }
        std::erase_if(segments_, [](const CurveSegment& segment) { return segment.force.empty(); });
        return std::move(segments_);
    }

private:
    void startSegment(const std::string& name) {
        if (segments_.empty() || name != name_) {
            segments_.emplace_back().kind = kindOf(name, lines_);
            name_ = name;
        }
    }

    /// A row whose cells are empty or "nan" holds no point: branches may differ in length.
    void add(const BranchColumns& columns, const std::vector<std::string>& cells,
             CurveSegment& segment) {
        const double distance = number(cells, columns.distance);
        const double force = number(cells, columns.force);
        if (!std::isfinite(distance) || !std::isfinite(force)) {
            return;
        }
        if (++points_ > kMaxPoints) {
            lines_.fail("more points than a force-distance curve has");
        }
        switch (table_.at(columns.distance).quantity) {
        case CurveQuantity::Base:
            segment.base.push_back(distance);
            break;
        case CurveQuantity::Indentation:
            segment.separation.push_back(-distance);
            break;
        default:
            segment.separation.push_back(distance);
            break;
        }
        segment.force.push_back(force);
        const double deflection =
            columns.deflection >= 0 ? number(cells, columns.deflection) : kNothing;
        if (std::isfinite(deflection)) {
            segment.deflection.push_back(deflection);
        }
    }

    /// In its SI unit.
    double number(const std::vector<std::string>& cells, int column) {
        std::string cell = cells[static_cast<std::size_t>(column)];
        if (cell.empty()) {
            return kNothing;
        }
        std::replace(cell.begin(), cell.end(), ',', '.');  // no separator of cells can be left
        const std::optional<double> value = parseNumber(cell);
        if (!value) {
            lines_.fail("'" + cell + "' is no number");
        }
        return table_.at(column).factor * *value;
    }

    static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

    const CurveTable& table_;
    TextLines& lines_;
    std::vector<CurveSegment> segments_;
    CurveSegment retract_;
    std::string name_;
    std::size_t points_ = 0;
};

std::size_t peakOf(const CurveSegment& segment) {
    return static_cast<std::size_t>(std::max_element(segment.force.begin(), segment.force.end()) -
                                    segment.force.begin());
}

/// At its largest force, which still belongs to the approach.
void splitAtTurn(std::vector<CurveSegment>& segments) {
    CurveSegment& approach = segments.front();
    const std::size_t kept = peakOf(approach) + 1;
    if (kept >= approach.force.size()) {
        return;
    }
    CurveSegment retract;
    retract.kind = CurveSegmentKind::Retract;
    for (const auto array : {&CurveSegment::base, &CurveSegment::separation,
                             &CurveSegment::deflection, &CurveSegment::force}) {
        std::vector<double>& from = approach.*array;
        if (!from.empty()) {
            const auto middle = from.begin() + static_cast<std::ptrdiff_t>(kept);
            (retract.*array).assign(middle, from.end());
            from.erase(middle, from.end());
        }
    }
    segments.push_back(std::move(retract));
}

/// The base grows towards the sample, where the force is largest.
void turnBase(std::vector<CurveSegment>& segments) {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double force = -std::numeric_limits<double>::infinity();
    double position = 0.0;  // of the largest force
    for (const CurveSegment& segment : segments) {
        for (std::size_t i = 0; i < segment.base.size(); ++i) {
            low = std::min(low, segment.base[i]);
            high = std::max(high, segment.base[i]);
            if (segment.force[i] > force) {
                force = segment.force[i];
                position = segment.base[i];
            }
        }
    }
    if (position - low < high - position) {
        for (CurveSegment& segment : segments) {
            for (double& base : segment.base) {
                base = -base;
            }
        }
    }
}

/// A deflection that some points lack is of no use.
void dropPartialDeflections(std::vector<CurveSegment>& segments) {
    for (CurveSegment& segment : segments) {
        if (segment.deflection.size() != segment.force.size()) {
            segment.deflection.clear();
        }
    }
}

/// Up to the line of titles. @throw InputError where there is none
CurveTable readTitles(TextLines& lines, double& stiffness, const std::string& file) {
    bool voltages = false;
    while (const std::optional<std::string_view> line = lines.next()) {
        if (line->find('\0') != std::string_view::npos) {
            throw InputError(file, "",
                             "holds binary data: a force curve is read from a text table; export "
                             "it as text, with base or separation and force, from the program "
                             "that made it");
        }
        if (line->starts_with('#')) {
            continue;
        }
        const std::vector<std::string> cells = curveCells(*line);
        if (const std::optional<CurveTable> table = tableOf(cells)) {
            return *table;
        }
        voltages = voltages || namesVoltages(cells);
        stiffness = std::max(stiffness, stiffnessIn(cells));
    }
    throw InputError(file, "",
                     voltages
                         ? "the lever's signal is in volts: export the curve with a calibrated "
                           "force, in newtons"
                         : "no line names a distance and a force with their units, such as "
                           "\"Z (nm), Force (nN)\" or \"base_m,force_N\"");
}

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

MeasuredForceCurve readForceCurve(const std::filesystem::path& path) {
    const BufferedFile file(path);
    TextLines lines(file);
    MeasuredForceCurve curve;
    const CurveTable table = readTitles(lines, curve.stiffness, path.string());
    RowReader rows(table, lines);
    while (const std::optional<std::string_view> line = lines.next()) {
        if (!trimmed(*line).empty() && !line->starts_with('#')) {
            rows.take(*line);
        }
    }
    curve.segments = rows.finish();
    if (curve.segments.empty()) {
        throw InputError(path.string(), "", "holds no point below its line of titles");
    }
    if (table.segment < 0 && !isWhole(table.second)) {
        splitAtTurn(curve.segments);
    }
    turnBase(curve.segments);
    dropPartialDeflections(curve.segments);
    return curve;
}

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
