#include "core/io/curves/ForceCurveFile.h"

#include "core/Error.h"
#include "core/io/BufferedFile.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveColumns.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity {

namespace {

constexpr std::size_t kMaxPoints = 20'000'000;

/// Where the columns of one branch are; -1: there is none.
struct BranchColumns {
    int distance = -1;
    int deflection = -1;
    int force = -1;
};

/// What the line of titles says.
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

/// None: the line names no distance and force.
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
    double place = 0.0;  // of the largest force
    for (const CurveSegment& segment : segments) {
        for (std::size_t i = 0; i < segment.base.size(); ++i) {
            low = std::min(low, segment.base[i]);
            high = std::max(high, segment.base[i]);
            if (segment.force[i] > force) {
                force = segment.force[i];
                place = segment.base[i];
            }
        }
    }
    if (place - low < high - place) {
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

}  // namespace asperity
