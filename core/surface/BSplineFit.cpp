#include "core/surface/BSplineFit.h"

#include "core/Error.h"
#include "core/surface/InvalidPixels.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// Samples on parallel lines: entry i of a lane lies `step` doubles after entry i - 1, lanes lie
/// side by side. There is one more place before entry 0 and one after the last: the padding.
struct Lanes {
    double* first = nullptr;
    std::size_t count = 0;  ///< entries in a line
    std::size_t step = 0;   ///< [doubles]
    std::size_t lanes = 0;

    [[nodiscard]] double* entry(std::size_t i) const { return first + i * step; }
};

/// Multipliers of the elimination for a line of `count` samples; they do not depend on the samples.
std::vector<double> eliminationFactors(std::size_t count) {
    std::vector<double> factors(count, 0.0);
    factors[0] = -1.0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        factors[i] = 1.0 / (4.0 - factors[i - 1]);
    }
    return factors;
}

/// Padding by straight continuation: all that one or two samples define.
void padStraight(const Lanes& line) {
    const double* begin = line.entry(0);
    const double* end = line.entry(line.count - 1);
    const double* afterBegin = line.entry(std::min<std::size_t>(1, line.count - 1));
    const double* beforeEnd = line.entry(line.count > 1 ? line.count - 2 : 0);
    for (std::size_t lane = 0; lane < line.lanes; ++lane) {
        line.first[lane - line.step] = 2.0 * begin[lane] - afterBegin[lane];
        line.entry(line.count)[lane] = 2.0 * end[lane] - beforeEnd[lane];
    }
}

/// Padding that leaves no third difference at either end.
void padQuadratic(const Lanes& line) {
    const std::size_t n = line.count;
    for (std::size_t lane = 0; lane < line.lanes; ++lane) {
        line.first[lane - line.step] =
            3.0 * (line.entry(0)[lane] - line.entry(1)[lane]) + line.entry(2)[lane];
        line.entry(n)[lane] =
            3.0 * (line.entry(n - 1)[lane] - line.entry(n - 2)[lane]) + line.entry(n - 3)[lane];
    }
}

/// Turns heights into control heights, in place, and fills the padding.
///
/// Inner rows of the system: c[i-1] + 4 c[i] + c[i+1] = 6 f[i]. Eliminating the padding with the
/// end condition leaves c[0] - c[1] = f[0] - f[1], and the mirror image at the other end.
void solve(const Lanes& line, const std::vector<double>& factors) {
    const std::size_t n = line.count;
    if (n < 3) {
        padStraight(line);
        return;
    }
    double* last = line.entry(n - 1);
    for (std::size_t lane = 0; lane < line.lanes; ++lane) {
        line.first[lane] -= line.entry(1)[lane];
        last[lane] -= line.entry(n - 2)[lane];
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        double* current = line.entry(i);
        const double* before = line.entry(i - 1);
        for (std::size_t lane = 0; lane < line.lanes; ++lane) {
            current[lane] = (6.0 * current[lane] - before[lane]) * factors[i];
        }
    }
    for (std::size_t lane = 0; lane < line.lanes; ++lane) {
        last[lane] = (last[lane] + line.entry(n - 2)[lane]) / (1.0 + factors[n - 2]);
    }
    for (std::size_t i = n - 1; i-- > 0;) {
        double* current = line.entry(i);
        const double* after = line.entry(i + 1);
        for (std::size_t lane = 0; lane < line.lanes; ++lane) {
            current[lane] -= factors[i] * after[lane];
        }
    }
    padQuadratic(line);
}

/// The heights, bottom row first, inside a frame of padding.
std::vector<double> paddedHeights(const HeightMap& map) {
    const auto columns = static_cast<std::size_t>(map.columns);
    const auto rows = static_cast<std::size_t>(map.rows);
    std::vector<double> padded((rows + 2) * (columns + 2));
    for (std::size_t row = 0; row < rows; ++row) {
        std::copy_n(map.heights.begin() + static_cast<std::ptrdiff_t>((rows - 1 - row) * columns),
                    columns,
                    padded.begin() + static_cast<std::ptrdiff_t>((row + 1) * (columns + 2) + 1));
    }
    return padded;
}

std::vector<std::uint8_t> bottomRowFirst(const std::vector<std::uint8_t>& mask, int columns) {
    std::vector<std::uint8_t> turned;
    turned.reserve(mask.size());
    for (auto end = mask.end(); end != mask.begin(); end -= columns) {
        turned.insert(turned.end(), end - columns, end);
    }
    return turned;
}

/// Single precision loses least half way between the lowest and the highest control height.
void storeControls(BSplineSurface::Grid& grid, const std::vector<double>& controls) {
    const auto [lowest, highest] = std::ranges::minmax_element(controls);
    grid.datum = 0.5 * *lowest + 0.5 * *highest;
    if (!(*highest - grid.datum <= std::numeric_limits<float>::max())) {
        throw Error("the heights of the map lie too far apart for a surface");
    }
    grid.controlHeights.reserve(controls.size());
    for (const double control : controls) {
        grid.controlHeights.push_back(static_cast<float>(control - grid.datum));
    }
}

BSplineSurface fitFinite(const HeightMap& map) {
    const auto columns = static_cast<std::size_t>(map.columns);
    const auto rows = static_cast<std::size_t>(map.rows);
    const std::size_t stride = columns + 2;
    std::vector<double> controls = paddedHeights(map);
    double* data = controls.data();

    const std::vector<double> alongX = eliminationFactors(columns);
    for (std::size_t row = 1; row <= rows; ++row) {
        solve({.first = data + row * stride + 1, .count = columns, .step = 1, .lanes = 1}, alongX);
    }
    solve({.first = data + stride, .count = rows, .step = stride, .lanes = stride},
          eliminationFactors(rows));
    BSplineSurface::Grid grid{.columns = map.columns,
                              .rows = map.rows,
                              .pitchX = map.pitchX,
                              .pitchY = map.pitchY,
                              .controlHeights = {},
                              .invalid = bottomRowFirst(map.invalid, map.columns)};
    storeControls(grid, controls);
    return BSplineSurface(std::move(grid));
}

}  // namespace

BSplineSurface fitSurface(const HeightMap& map) {
    requireUsable(map);
    const bool complete =
        std::ranges::all_of(map.heights, [](double height) { return isFiniteHeight(height); });
    return complete ? fitFinite(map) : fitFinite(withInvalidPixelsFilled(map));
}

}  // namespace asperity
