#include "core/io/curves/text/TextCurve.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveSegments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

// Force curves in text tables, whose columns are named by titles or by the user. Source:
// docs/formats.md 21.

namespace asperity {

namespace {

constexpr std::size_t kMaxPoints = 20'000'000;

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
    branch.time = find(columns, CurveQuantity::Time, retract);
    branch.signal = find(columns, CurveQuantity::Voltage, retract);
    branch.deflection = find(columns, CurveQuantity::Deflection, retract);
    branch.force = find(columns, CurveQuantity::Force, retract);
    return branch;
}

CurveTable tableOf(std::vector<CurveColumn> columns) {
    CurveTable table;
    table.columns = std::move(columns);
    table.first = branchColumns(table.columns, false);
    table.second = branchColumns(table.columns, true);
    table.segment = find(table.columns, CurveQuantity::Segment, false);
    return table;
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

/// Reads the rows below the titles.
class RowReader {
public:
    RowReader(const CurveTable& table, TextLines& lines) : table_(table), lines_(lines) {}

    void take(std::string_view line) {
        std::vector<std::string> cells =
            table_.numbers.empty() ? curveCells(line) : curveCells(line, table_.numbers);
        if (cells.empty()) {
            refuseRow(line);
            return;
        }
        cells.resize(std::max(cells.size(), table_.columns.size()));
        if (table_.segment >= 0) {
            startSegment(cells[static_cast<std::size_t>(table_.segment)]);
        } else if (segments_.empty()) {
            segments_.emplace_back();
        }
        add(table_.first, cells, segments_.back());
        if (table_.second.isWhole()) {
            add(table_.second, cells, retract_);
        }
    }

    [[nodiscard]] std::vector<CurveSegment> finish() {
        if (!loadOf(retract_).empty()) {
            retract_.kind = CurveSegmentKind::Retract;
            segments_.push_back(std::move(retract_));
        }
        std::ranges::for_each(segments_, dropPartial);
        std::erase_if(segments_,
                      [](const CurveSegment& segment) { return loadOf(segment).empty(); });
        return std::move(segments_);
    }

private:
    /// Text above the rows of a table without titles is left out.
    void refuseRow(std::string_view line) const {
        if (!segments_.empty()) {
            lines_.fail("expected numbers in the named columns, found '" +
                        std::string(line.substr(0, 60)) + "'");
        }
    }

    void startSegment(const std::string& name) {
        if (!segments_.empty() && name == name_) {
            return;
        }
        bool known = false;
        segments_.emplace_back().kind = segmentKind(name, known);
        if (!known) {
            lines_.fail("'" + name + "' is no segment: approach, pause, retract or modulation is");
        }
        name_ = name;
    }

    /// A row whose cells are empty or "nan" holds no point: branches may differ in length.
    void add(const BranchColumns& columns, const std::vector<std::string>& cells,
             CurveSegment& segment) {
        const double distance = number(cells, columns.distance);
        const std::array values{number(cells, columns.time), number(cells, columns.signal),
                                number(cells, columns.deflection), number(cells, columns.force)};
        const bool isPoint = std::isfinite(distance) &&
                             std::any_of(values.begin() + 1, values.end(),
                                         [](double value) { return std::isfinite(value); });
        if (!isPoint) {
            return;
        }
        if (++points_ > kMaxPoints) {
            lines_.fail("more points than a force-distance curve has");
        }
        switch (table_.columns[static_cast<std::size_t>(columns.distance)].quantity) {
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
        for (std::size_t i = 0; i < values.size(); ++i) {
            (segment.*kOptional[i]).push_back(values[i]);
        }
    }

    /// In its SI unit.
    double number(const std::vector<std::string>& cells, int column) {
        if (column < 0) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        const std::string& cell = cells[static_cast<std::size_t>(column)];
        const std::optional<double> value = cellNumber(cell);
        if (!value) {
            lines_.fail("'" + cell + "' is no number");
        }
        return table_.columns[static_cast<std::size_t>(column)].factor * *value;
    }

    /// An array that some points lack is of no use.
    static void dropPartial(CurveSegment& segment) {
        for (const auto array : kOptional) {
            if (!std::ranges::all_of(segment.*array,
                                     [](double value) { return std::isfinite(value); })) {
                (segment.*array).clear();
            }
        }
    }

    static constexpr std::array kOptional{&CurveSegment::time, &CurveSegment::signal,
                                          &CurveSegment::deflection, &CurveSegment::force};

    const CurveTable& table_;
    TextLines& lines_;
    std::vector<CurveSegment> segments_;
    CurveSegment retract_;
    std::string name_;
    std::size_t points_ = 0;
};

/// Notes the lever and the tip in the lines above the table.
void takeFacts(const std::vector<std::string>& cells, CurveContents& contents) {
    contents.curve.stiffness = std::max(contents.curve.stiffness, stiffnessIn(cells));
    if (cells.size() >= 2 && lowerCase(cells[0]).starts_with("tip radius (")) {
        contents.notes.push_back("the file names the tip: " + toUtf8(cells[0]) + " " +
                                 toUtf8(cells[1]));
    }
}

/// Up to the line of titles. @throw InputError where there is none
CurveTable readTitles(TextLines& lines, CurveContents& contents, const std::string& file) {
    while (const std::optional<std::string_view> line = lines.next()) {
        if (line->starts_with('#')) {
            continue;
        }
        const std::vector<std::string> cells = curveCells(*line);
        if (const std::optional<CurveTable> table = titledTable(cells)) {
            return *table;
        }
        takeFacts(cells, contents);
    }
    throw InputError(file, "",
                     "no line names a distance and a force, a deflection or a signal with their "
                     "units, such as \"Z (nm), Force (nN)\" or \"base_m,force_N\"");
}

/// Columns of a branch may be stored from the far end or from the contact on.
void orderBranch(CurveSegment& segment) {
    if (segment.base.empty()) {
        return;
    }
    const bool approaches = segment.base.front() < segment.base.back();
    if (approaches == (segment.kind == CurveSegmentKind::Approach)) {
        return;
    }
    for (const auto array : kCurveArrays) {
        std::ranges::reverse(segment.*array);
    }
}

}  // namespace

std::optional<CurveTable> titledTable(const std::vector<std::string>& titles) {
    std::vector<CurveColumn> columns;
    columns.reserve(titles.size());
    for (const std::string& title : titles) {
        columns.push_back(curveColumn(title));
    }
    CurveTable table = tableOf(std::move(columns));
    return table.first.isWhole() ? std::optional(std::move(table)) : std::nullopt;
}

CurveTable givenTable(const std::vector<GivenColumn>& given) {
    std::vector<CurveColumn> columns;
    std::vector<int> numbers;
    for (const GivenColumn& each : given) {
        columns.resize(std::max(columns.size(), static_cast<std::size_t>(each.number)));
        columns[static_cast<std::size_t>(each.number) - 1] = each.column;
        if (each.column.quantity != CurveQuantity::Segment) {
            numbers.push_back(each.number);
        }
    }
    CurveTable table = tableOf(std::move(columns));
    if (table.second.distance < 0) {
        table.second.distance = table.first.distance;
    }
    table.numbers = std::move(numbers);
    return table;
}

bool hasCurveTitles(const ByteSource& bytes) {
    constexpr std::uint64_t kLooked = std::uint64_t{1} << 16U;
    const std::string start = bytes.start(kLooked);
    const bool isUtf16 = start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF");
    if (!isUtf16 && start.find('\0') != std::string::npos) {
        return false;
    }
    const MemoryBytes text(start, bytes.name());
    TextLines lines(text);
    while (const std::optional<std::string_view> line = lines.next()) {
        if (!line->starts_with('#') && titledTable(curveCells(*line))) {
            return true;
        }
    }
    return false;
}

CurveContents readTextCurve(const ByteSource& bytes, const CurveReadOptions& options,
                            const std::optional<CurveTable>& given) {
    if (!options.height.empty()) {
        throw InputError(bytes.name(), "",
                         "a text table has no height channels to choose from: name its columns");
    }
    TextLines lines(bytes);
    for (int i = 0; i < options.skippedLines && lines.next(); ++i) {
    }
    CurveContents contents;
    const CurveTable table = given ? *given : readTitles(lines, contents, bytes.name());
    RowReader rows(table, lines);
    while (const std::optional<std::string_view> line = lines.next()) {
        if (!trimmed(*line).empty() && !line->starts_with('#')) {
            rows.take(*line);
        }
    }
    std::vector<CurveSegment>& segments = contents.curve.segments;
    segments = rows.finish();
    if (segments.empty()) {
        throw InputError(bytes.name(), "", "holds no point below its line of titles");
    }
    if (table.segment < 0 && !table.second.isWhole()) {
        splitAtTurn(segments);
    }
    turnBase(segments);
    if (table.second.isWhole()) {
        std::ranges::for_each(segments, orderBranch);
    }
    finishCurve(contents, bytes.name());
    return contents;
}

}  // namespace asperity
