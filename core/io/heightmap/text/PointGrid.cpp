#include "core/io/heightmap/text/PointGrid.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace asperity {

namespace {

constexpr std::size_t kCells = 1000000;  // of the range of a coordinate
constexpr std::size_t kMaxNodes = 65536;
constexpr double kMaxShift = 0.1;  // of a point from its node, in pitches

/// The range of a coordinate.
struct Range {
    double first = 0.0;
    double last = 0.0;

    [[nodiscard]] double width() const { return last - first; }
};

Range rangeOf(const TextPoints& points, std::size_t axis) {
    Range range{points.at(0, axis), points.at(0, axis)};
    for (std::size_t i = 1; i < points.size(); ++i) {
        range.first = std::min(range.first, points.at(i, axis));
        range.last = std::max(range.last, points.at(i, axis));
    }
    return range;
}

/// A bit for each cell of the range.
class Cells {
public:
    void add(std::size_t cell) { words_[cell / kBits] |= std::uint64_t{1} << (cell % kBits); }
    /// The first cell from `cell` on that is added, or is none; kEnd behind the last.
    [[nodiscard]] std::size_t next(std::size_t cell, bool added) const {
        for (std::size_t word = cell / kBits; word < words_.size(); ++word) {
            const std::uint64_t all = added ? words_[word] : ~words_[word];
            const std::uint64_t left = word == cell / kBits ? all >> (cell % kBits) : all;
            if (left != 0) {
                const std::size_t first = word == cell / kBits ? cell : word * kBits;
                return first + static_cast<std::size_t>(std::countr_zero(left));
            }
        }
        return kEnd;
    }

    static constexpr std::size_t kEnd = std::numeric_limits<std::size_t>::max();

private:
    static constexpr std::size_t kBits = 64;

    std::vector<std::uint64_t> words_ = std::vector<std::uint64_t>(kCells / kBits + 1);
};

/// Returns the cells of the range that hold a coordinate.
Cells occupiedCells(const TextPoints& points, std::size_t axis, const Range& range) {
    Cells cells;
    const double perCell = kCells / range.width();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double cell = (points.at(i, axis) - range.first) * perCell;
        cells.add(std::min(static_cast<std::size_t>(std::lround(cell)), kCells));
    }
    return cells;
}

/// The middle of each run of cells that hold a coordinate, in cells; none when a run is longer than
/// one coordinate can be, or there are too many.
std::vector<double> nodePositions(const Cells& cells) {
    constexpr std::size_t kLongestRun = 3;
    std::vector<double> positions;
    for (std::size_t i = cells.next(0, true); i != Cells::kEnd;) {
        const std::size_t end = cells.next(i, false);
        positions.push_back(static_cast<double>(i + end - 1) / 2.0);
        if (end - i > kLongestRun || positions.size() > kMaxNodes) {
            return {};
        }
        i = cells.next(end, true);
    }
    return positions;
}

double medianStep(const std::vector<double>& positions) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < positions.size(); ++i) {
        steps.push_back(positions[i] - positions[i - 1]);
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

}  // namespace

std::optional<GridAxis> gridAxis(const TextPoints& points, std::size_t axis) {
    const Range range = rangeOf(points, axis);
    if (range.width() == 0.0) {
        return GridAxis{.first = range.first, .pitch = 0.0, .count = 1};
    }
    const bool usable = std::isnormal(range.width()) && std::isfinite(kCells / range.width());
    const std::vector<double> positions =
        usable ? nodePositions(occupiedCells(points, axis, range)) : std::vector<double>();
    if (positions.size() < 2) {
        return std::nullopt;
    }
    // Each step is a whole number of pitches; all of them together give the pitch exactly.
    const double step = medianStep(positions);
    std::vector<double> nodes{0.0};
    for (std::size_t i = 1; i < positions.size(); ++i) {
        nodes.push_back(nodes.back() + std::round((positions[i] - positions[i - 1]) / step));
    }
    if (nodes.back() >= static_cast<double>(kMaxNodes)) {
        return std::nullopt;
    }
    const double pitch = static_cast<double>(kCells) / nodes.back();  // [cells]
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (std::abs(positions[i] - nodes[i] * pitch) > kMaxShift * pitch) {
            return std::nullopt;
        }
    }
    return GridAxis{.first = range.first,
                    .pitch = range.width() / nodes.back(),
                    .count = static_cast<int>(nodes.back()) + 1};
}

}  // namespace asperity
