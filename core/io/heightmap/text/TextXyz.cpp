#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ForceCurveFiles.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/text/PointGrid.h"
#include "core/io/heightmap/text/TextRows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

// Points of a grid as text, x, y and z in each line, in any order; the largest y is the top row.
// Source: docs/formats.md 4.

namespace asperity {

namespace {

/// A grid has about one node for each of its points; with fewer nodes, points are there twice.
constexpr double kMinNodesPerPoint = 0.8;
constexpr double kMaxNodesPerPoint = 1.2;
constexpr std::size_t kNoPoint = std::numeric_limits<std::size_t>::max();

/// Takes memory when it has a point.
struct GridRow {
    std::vector<double> heights;      ///< NaN: none
    std::vector<std::size_t> points;  ///< that gave them

    void begin(std::size_t columns) {
        if (heights.empty()) {
            heights.assign(columns, std::numeric_limits<double>::quiet_NaN());
            points.assign(columns, kNoPoint);
        }
    }
};

/// Reads rows that are in memory.
ReadRow rowsOf(std::vector<GridRow> rows) {
    return [kept = std::make_shared<const std::vector<GridRow>>(std::move(rows))](int row, RowRoom&,
                                                                                  double* target) {
        std::ranges::copy((*kept)[static_cast<std::size_t>(row)].heights, target);
    };
}

class TextXyzReader {
public:
    explicit TextXyzReader(const ByteSource& bytes)
        : file_(bytes.name())
        , lines_(bytes)
        , header_(requireTextHeader(lines_))
        , rows_(lines_, header_) {}

    StoredScan read() {
        readPoints();
        findGrid();
        ScanChannel channel;
        channel.name = header_.title.empty() ? "z" : header_.title;
        channel.unit = header_.pointUnits[2].base;
        channel.direction = directionFromName(channel.name);
        setSize(channel);
        addProvenance(channel);
        ReadRow rows = rowsOf(rowsOnGrid(channel));
        StoredScan scan;
        scan.texts = std::move(header_.texts);
        scan.channels.push_back({.channel = std::move(channel),
                                 .factor = header_.pointUnits[2].factor,
                                 .readRow = std::move(rows)});
        return scan;
    }

private:
    void readPoints() {
        if (rows_.columns() != 3) {
            lines_.fail("expected x, y and z, found " + std::to_string(rows_.columns()) +
                        " numbers");
        }
        for (auto point = rows_.next(); !point.empty(); point = rows_.next()) {
            if (!std::isfinite(point[0]) || !std::isfinite(point[1])) {
                lines_.fail("expected numbers for x and y of a point");
            }
            points_.numbers.insert(points_.numbers.end(), point.begin(), point.end());
        }
    }

    /// Returns whether the first column rises or falls in equal steps from line to line: of points
    /// on a grid it repeats.
    [[nodiscard]] bool isCurve() const {
        constexpr std::size_t kFewest = 10;
        const std::size_t count = points_.size();
        if (count < kFewest) {
            return false;
        }
        const auto first = [this](std::size_t line) { return points_.numbers[3 * line]; };
        const double step = (first(count - 1) - first(0)) / static_cast<double>(count - 1);
        for (std::size_t i = 1; i < count; ++i) {
            if (!(std::abs(first(i) - first(i - 1) - step) < 0.1 * std::abs(step))) {
                return false;
            }
        }
        return true;
    }

    void findGrid() {
        if (isCurve()) {
            throw InputError(file_, "",
                             "three columns of numbers, the first in equal steps, are a curve and "
                             "no height map: NT-MDT exports force curves so, approach beside "
                             "retract" +
                                 std::string(kCurvePointer));
        }
        const std::optional<GridAxis> x = gridAxis(points_, 0);
        const std::optional<GridAxis> y = gridAxis(points_, 1);
        const std::size_t count = points_.size();
        const double nodes = x && y ? static_cast<double>(x->count) * y->count : 0.0;
        const auto points = static_cast<double>(count);
        if (nodes < kMinNodesPerPoint * points || nodes > kMaxNodesPerPoint * points) {
            throw InputError(
                file_, "",
                "three columns of numbers are read as x, y and z of points, and these " +
                    std::to_string(count) +
                    " lie on no regular grid; interpolate them onto one first, with "
                    "Gwyddion for instance");
        }
        if (x->count == 1 || y->count == 1) {
            throw InputError(file_, "", "all points lie on one line: a profile, no height map");
        }
        x_ = *x;
        y_ = *y;
    }

    void setSize(ScanChannel& channel) {
        const PhysicalUnit& xUnit = header_.pointUnits[0];
        const PhysicalUnit& yUnit = header_.pointUnits[1];
        const ImageSize size = checkedImageSize(x_.count, y_.count, file_, "grid");
        const bool known = !xUnit.base.empty() && xUnit.base == yUnit.base;
        const double pitchX = known ? x_.pitch * xUnit.factor : 0.0;
        const double pitchY = known ? y_.pitch * yUnit.factor : 0.0;
        channel.map = emptyMap(size, pitchX * size.columns, pitchY * size.rows);
        if (known) {
            channel.lateralUnit = xUnit.base;
            setOrigin(channel, x_.first * xUnit.factor, y_.first * yUnit.factor,
                      GivenPoint::FirstPixel);
        } else {
            channel.notes.push_back("x and y have no unit; their steps are " + exactText(x_.pitch) +
                                    " and " + exactText(y_.pitch));
        }
        settleSize(channel, "the coordinates of all points");
    }

    void addProvenance(ScanChannel& channel) {
        const PhysicalUnit& unit = header_.pointUnits[2];
        if (!unit.base.empty()) {
            channel.provenance.push_back(
                scaleProvenance(unit.factor, unit.base, header_.unitSource));
        }
        std::ranges::move(rows_.provenance(), std::back_inserter(channel.provenance));
        channel.provenance.push_back({"grid",
                                      std::to_string(x_.count) + " x " + std::to_string(y_.count) +
                                          " nodes, steps " + exactText(x_.pitch) + " and " +
                                          exactText(y_.pitch),
                                      "the coordinates of all points"});
        channel.provenance.push_back(
            {"orientation", "the largest y is the top row", "usual; the file does not say"});
    }

    /// Consumes the points, so that each needs memory once.
    /// @throw InputError when two points lie on the same node
    std::vector<GridRow> rowsOnGrid(ScanChannel& channel) {
        const auto columns = static_cast<std::size_t>(x_.count);
        const std::size_t count = points_.size();
        std::vector<GridRow> rows(static_cast<std::size_t>(y_.count));
        for (std::size_t i = 0; i < count; ++i) {
            const double x = points_.at(0, 0);
            const double y = points_.at(0, 1);
            GridRow& row = rows[static_cast<std::size_t>(y_.count - 1 - y_.nodeOf(y))];
            const auto column = static_cast<std::size_t>(x_.nodeOf(x));
            row.begin(columns);
            if (row.points[column] != kNoPoint) {
                throw InputError(file_,
                                 "points " + std::to_string(row.points[column] + 1) + " and " +
                                     std::to_string(i + 1),
                                 "two points lie at x = " + exactText(x) + ", y = " + exactText(y));
            }
            row.points[column] = i;
            row.heights[column] = points_.at(0, 2);
            points_.removeFirst();
        }
        const std::size_t nodes = rows.size() * columns;
        if (nodes > count) {  // no two points lie on one
            channel.notes.push_back(std::to_string(nodes - count) + " of " + std::to_string(nodes) +
                                    " nodes of the grid have no point");
        }
        for (GridRow& row : rows) {
            row.begin(columns);
            row.points = {};
        }
        return rows;
    }

    std::string file_;
    TextLines lines_;
    TextHeader header_;
    TextRows rows_;
    TextPoints points_;
    GridAxis x_;
    GridAxis y_;
};

constexpr std::array<std::string_view, 4> kXyzExtensions{".xyz", ".asc", ".csv", ".dat"};

bool isXyz(const ByteSource& bytes) {
    const std::optional<TextHeader> header = glanceAtText(bytes);
    return header && holdsPoints(*header);
}

}  // namespace

const HeightMapFormat kXyzFormat = {
    .name = "XYZ points",
    .extensions = kXyzExtensions,
    .recognizes = isXyz,
    .read = [](const ByteSource& bytes) { return TextXyzReader(bytes).read(); }};

}  // namespace asperity
