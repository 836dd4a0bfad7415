#include "core/surface/measure/Profile.h"

#include "core/surface/LeastSquares.h"
#include "core/surface/PixelField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

/// Mean and variance of samples.
struct Level {
    double count = 0.0;
    double mean = 0.0;    ///< [m]
    double square = 0.0;  ///< sum of squares about the mean [m^2]

    void add(double height) {
        count += 1.0;
        const double step = height - mean;
        mean += step / count;
        square += step * (height - mean);
    }
    [[nodiscard]] double variance() const { return square / count; }
};

Level levelOf(const Profile& profile, const Interval& stretch) {
    Level level;
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        if (stretch.contains(profile.distance(i)) && isFiniteHeight(profile.heights[i])) {
            level.add(profile.heights[i]);
        }
    }
    return level;
}

/// The height between the two parts of the heights whose variance is largest; none where all are
/// the same.
std::optional<double> splittingHeight(const Profile& profile) {
    std::vector<double> sorted;
    std::ranges::copy_if(profile.heights, std::back_inserter(sorted),
                         [](double height) { return isFiniteHeight(height); });
    std::ranges::sort(sorted);
    if (sorted.empty() || sorted.front() == sorted.back()) {
        return std::nullopt;
    }
    double sum = 0.0;
    for (const double height : sorted) {
        sum += height - sorted.front();
    }
    const auto count = static_cast<double>(sorted.size());
    double below = 0.0;
    double best = -1.0;
    double split = sorted.front();
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
        below += sorted[i] - sorted.front();
        const double lower = static_cast<double>(i) + 1.0;
        const double apart = (sum - below) / (count - lower) - below / lower;
        const double between = lower * (count - lower) * apart * apart;
        if (between > best) {
            best = between;
            split = 0.5 * (sorted[i] + sorted[i + 1]);
        }
    }
    return split;
}

/// Samples [first, end) on one side of the splitting height.
struct Plateau {
    std::size_t first = 0;
    std::size_t end = 0;
    bool isHigh = false;
};

/// The runs between two edges, each cut down to its middle third.
std::vector<Plateau> plateausOf(const Profile& profile, double split) {
    constexpr std::size_t kMinSamples = 3;
    const std::vector<double>& heights = profile.heights;
    std::vector<Plateau> plateaus;
    std::size_t first = 0;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const bool known = isFiniteHeight(heights[i - 1]) && isFiniteHeight(heights[i]);
        const bool isHigh = isFiniteHeight(heights[i - 1]) && heights[i - 1] > split;
        if (known && (heights[i] > split) == isHigh) {
            continue;
        }
        const std::size_t run = i - first;
        const bool cut = first == 0 || !known || !isFiniteHeight(heights[first - 1]);
        if (!cut && run >= kMinSamples) {
            plateaus.push_back({.first = first + run / 3, .end = i - run / 3, .isHigh = isHigh});
        }
        first = i;
    }
    return plateaus;
}

/// Heights between the pixels of a grid. @param pixel its height; NaN: no data
template <class Grid, class Pixel>
HeightField fieldBetween(const Grid& grid, Pixel pixel) {
    return {.pitchX = grid.pitchX,
            .pitchY = grid.pitchY,
            .at = [columns = grid.columns, rows = grid.rows, pitchX = grid.pitchX,
                   pitchY = grid.pitchY, pixel](double x, double y) {
                if (!(x >= 0.0 && x <= columns * pitchX && y >= 0.0 && y <= rows * pitchY)) {
                    return kNoData;
                }
                return bilinear(betweenPixels(onCenter(rows - 0.5 - y / pitchY), rows),
                                betweenPixels(onCenter(x / pitchX - 0.5), columns), pixel);
            }};
}

/// @param datum to which the heights are relative [m]
template <class Map>
HeightField fieldBetweenPixels(const Map& map, double datum) {
    return fieldBetween(map, [&map, datum](int row, int column) {
        const double height = map.at(row, column);
        return map.isValid(row, column) && isFiniteHeight(height) ? datum + height : kNoData;
    });
}

}  // namespace

void requireLine(const Vector2& from, const Vector2& to, int samples) {
    if (samples < 2) {
        throw Error("a profile needs at least two samples");
    }
    if (!isFinite(from) || !isFinite(to) || !((to - from).norm() > 0.0)) {
        throw Error("a profile needs two points apart from each other");
    }
}

HeightField fieldOf(const BSplineSurface& surface) {
    return {.pitchX = surface.grid().pitchX,
            .pitchY = surface.grid().pitchY,
            .at = [&surface](double x, double y) {
                const bool known = surface.contains(x, y) && surface.isMeasured(x, y);
                return known ? surface.at(x, y).height : kNoData;
            }};
}

HeightField bilinearField(const HeightMap& map) { return fieldBetweenPixels(map, 0.0); }
HeightField bilinearField(const ScanMap& map) { return fieldBetweenPixels(map, map.datum); }

HeightField bilinearField(const BSplineSurface& surface) {
    const BSplineSurface::Grid& grid = surface.grid();
    return fieldBetween(grid, [exact = fieldOf(surface), &grid](int row, int column) {
        return exact.at((column + 0.5) * grid.pitchX, (grid.rows - row - 0.5) * grid.pitchY);
    });
}

int usualSamples(double pitchX, double pitchY, const Vector2& from, const Vector2& to) {
    constexpr double kMax = 1e6;
    const double pixels = std::hypot((to.x() - from.x()) / pitchX, (to.y() - from.y()) / pitchY);
    return 1 + static_cast<int>(std::clamp(std::ceil(pixels), 1.0, kMax));
}

double heightAt(const Profile& profile, double distance) {
    constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();
    const double length = profile.length();
    if (!(distance >= 0.0 && distance <= length)) {
        return kNoData;
    }
    const auto last = profile.heights.size() - 1;
    const double position = distance / length * static_cast<double>(last);
    const auto before = std::min(static_cast<std::size_t>(position), last - 1);
    const double share = position - static_cast<double>(before);
    if (share == 0.0) {
        return profile.heights[before];
    }
    if (share == 1.0) {
        return profile.heights[before + 1];
    }
    return (1.0 - share) * profile.heights[before] + share * profile.heights[before + 1];
}

std::optional<PointReading> readingBetween(const Profile& profile, double first, double second) {
    const auto [from, to] = std::minmax(first, second);
    const double rise = heightAt(profile, to) - heightAt(profile, from);
    if (!isFiniteHeight(rise) || !(to > from)) {
        return std::nullopt;
    }
    return PointReading{.distance = to - from, .rise = rise, .angle = std::atan2(rise, to - from)};
}

std::optional<double> fittedAngle(const Profile& profile, const Interval& stretch) {
    double count = 0.0;
    double meanDistance = 0.0;
    double meanHeight = 0.0;
    double square = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        const double distance = profile.distance(i);
        if (!stretch.contains(distance) || !isFiniteHeight(profile.heights[i])) {
            continue;
        }
        // Running means: an offset of the heights costs no digits.
        count += 1.0;
        const double step = distance - meanDistance;
        meanDistance += step / count;
        meanHeight += (profile.heights[i] - meanHeight) / count;
        square += step * (distance - meanDistance);
        product += step * (profile.heights[i] - meanHeight);
    }
    if (!(square > 0.0)) {
        return std::nullopt;
    }
    return std::atan(product / square);
}

std::optional<StepHeight> stepHeight(const Profile& profile, const Interval& low,
                                     const Interval& high) {
    const Level below = levelOf(profile, low);
    const Level above = levelOf(profile, high);
    if (below.count == 0.0 || above.count == 0.0) {
        return std::nullopt;
    }
    return StepHeight{.height = above.mean - below.mean,
                      .deviation = std::sqrt(below.variance() + above.variance()),
                      .samples = static_cast<std::size_t>(below.count + above.count),
                      .plateaus = 2};
}

std::optional<StepHeight> gratingHeight(const Profile& profile) {
    const std::optional<double> split = splittingHeight(profile);
    if (!split) {
        return std::nullopt;
    }
    const std::vector<Plateau> plateaus = plateausOf(profile, *split);
    const auto isHigh = [](const Plateau& plateau) { return plateau.isHigh; };
    if (std::ranges::none_of(plateaus, isHigh) || std::ranges::all_of(plateaus, isHigh)) {
        return std::nullopt;
    }
    std::size_t samples = 0;
    for (const Plateau& plateau : plateaus) {
        samples += plateau.end - plateau.first;
    }
    Eigen::MatrixXd design(static_cast<Eigen::Index>(samples), 3);
    Eigen::VectorXd heights(static_cast<Eigen::Index>(samples));
    Eigen::Index line = 0;
    for (const Plateau& plateau : plateaus) {
        for (std::size_t i = plateau.first; i < plateau.end; ++i, ++line) {
            const double position =
                static_cast<double>(i) / static_cast<double>(profile.heights.size() - 1) - 0.5;
            design.row(line) << 1.0, position, plateau.isHigh ? 0.5 : -0.5;
            heights(line) = profile.heights[i] - *split;
        }
    }
    const Eigen::Vector3d fit = leastSquares(design, heights);
    const double square = (heights - design * fit).squaredNorm();
    return StepHeight{.height = fit.z(),
                      .deviation = std::sqrt(square / static_cast<double>(samples)),
                      .samples = samples,
                      .plateaus = plateaus.size()};
}

}  // namespace asperity
