#include "core/surface/measure/Texture.h"

#include "core/Error.h"
#include "core/surface/measure/HalfSpectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <span>
#include <vector>

namespace asperity {

namespace {

constexpr double kDecayLevel = 0.2;  // to which the autocorrelation falls, ISO 25178-2
constexpr int kLongestSide = 2048;   // [pixel]

std::size_t cellAt(int index) { return static_cast<std::size_t>(index); }

/// Heights of a rectangle about their mean, 0 where there is no data, and 1 where there is some.
struct SampledHeights {
    int columns = 0;
    int rows = 0;
    std::vector<double> heights;  ///< row-major [m]
    std::vector<double> mask;
};

SampledHeights sampledHeights(const HeightRows& map, const PixelRectangle& pixels, int step,
                              Progress* progress) {
    SampledHeights sampled{.columns = (pixels.columns - 1) / step + 1,
                           .rows = (pixels.rows - 1) / step + 1,
                           .heights = {},
                           .mask = {}};
    sampled.heights.reserve(cellAt(sampled.columns) * cellAt(sampled.rows));
    std::vector<double> row(cellAt(map.columns));
    for (int i = 0; i < sampled.rows; ++i) {
        reportLoop(progress, i, sampled.rows);
        map.readRow(pixels.row + i * step, row.data());
        for (int j = 0; j < sampled.columns; ++j) {
            sampled.heights.push_back(row[cellAt(pixels.column + j * step)]);
        }
    }
    sampled.mask.resize(sampled.heights.size());
    std::ranges::transform(sampled.heights, sampled.mask.begin(),
                           [](double height) { return isFiniteHeight(height) ? 1.0 : 0.0; });
    return sampled;
}

/// @throw Error when none holds data
void subtractMean(SampledHeights& sampled) {
    const auto first =
        std::ranges::find_if(sampled.heights, [](double height) { return isFiniteHeight(height); });
    if (first == sampled.heights.end()) {
        throw Error("no pixel of the rectangle holds data");
    }
    const double origin = *first;  // an offset costs no digits
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < sampled.heights.size(); ++i) {
        sampled.heights[i] = sampled.mask[i] > 0.0 ? sampled.heights[i] - origin : 0.0;
        sum += sampled.heights[i];
        count += sampled.mask[i];
    }
    for (std::size_t i = 0; i < sampled.heights.size(); ++i) {
        sampled.heights[i] -= sampled.mask[i] * sum / count;
    }
}

/// Sums of the products of a field with itself, shifted by up to half of its sides. Behind each row
/// and column follow at least as many zeros as there are lags, so that no end meets the other.
class LagSums {
public:
    LagSums(int columns, int rows)
        : columns_(columns)
        , rows_(rows)
        , lagsX_(columns / 2)
        , lagsY_(rows / 2)
        , spectrum_(columns + lagsX_, rows + lagsY_) {}

    [[nodiscard]] int lagsX() const { return lagsX_; }
    [[nodiscard]] int lagsY() const { return lagsY_; }

    /// Returns the sums at the lags -lagsX .. lagsX of each row, for the lags 0 .. lagsY of the
    /// columns. @throw Canceled
    std::vector<double> of(const std::vector<double>& field, Progress* progress) {
        spectrum_.clear();
        ProgressPart rows(progress, 0.0, 0.3);
        for (int row = 0; row < rows_; ++row) {
            reportLoop(&rows, row, rows_);
            spectrum_.setRow(
                row, std::span(field).subspan(cellAt(row) * cellAt(columns_), cellAt(columns_)));
        }
        ProgressPart columns(progress, 0.3, 0.8);
        for (int wave = 0; wave < spectrum_.waves(); ++wave) {
            reportLoop(&columns, wave, spectrum_.waves());
            for (std::complex<double>& value : spectrum_.transformColumn(wave)) {
                value = std::norm(value);
            }
            spectrum_.returnColumn(wave);
        }
        ProgressPart back(progress, 0.8, 1.0);
        return inverseRows(&back);
    }

private:
    std::vector<double> inverseRows(Progress* progress) {
        const int period = spectrum_.periodX();
        const double scale = 1.0 / (static_cast<double>(period) * spectrum_.periodY());
        std::vector<double> sums;
        sums.reserve(cellAt(lagsY_ + 1) * cellAt(2 * lagsX_ + 1));
        for (int row = 0; row <= lagsY_; ++row) {
            reportLoop(progress, row, lagsY_ + 1);
            const std::span<const double> values = spectrum_.row(row);
            for (int lag = -lagsX_; lag <= lagsX_; ++lag) {
                sums.push_back(scale * values[cellAt((lag + period) % period)]);
            }
        }
        return sums;
    }

    int columns_;
    int rows_;
    int lagsX_;
    int lagsY_;
    HalfSpectrum spectrum_;
};

/// The normalized autocorrelation, which is the same at opposite lags: half of it is kept.
struct Autocorrelation {
    int lagsX = 0;
    int lagsY = 0;
    std::vector<double> values;  ///< as LagSums::of(); NaN where no pair of pixels has data

    [[nodiscard]] std::size_t index(int x, int y) const {
        return cellAt(y) * cellAt(2 * lagsX + 1) + cellAt(x + lagsX);
    }
    [[nodiscard]] bool isAtBorder(int x, int y) const { return std::abs(x) == lagsX || y == lagsY; }
};

/// Without lags when all heights are the same.
Autocorrelation autocorrelationOf(const SampledHeights& sampled, Progress* progress) {
    LagSums sums(sampled.columns, sampled.rows);
    Autocorrelation result{.lagsX = sums.lagsX(), .lagsY = sums.lagsY(), .values = {}};
    if (std::ranges::all_of(sampled.heights, [](double height) { return height == 0.0; })) {
        return result;
    }
    ProgressPart first(progress, 0.0, 0.5);
    result.values = sums.of(sampled.heights, &first);
    ProgressPart second(progress, 0.5, 1.0);
    const std::vector<double> pairs = sums.of(sampled.mask, &second);
    const std::size_t origin = result.index(0, 0);
    const double variance = result.values[origin] / pairs[origin];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const bool hasPair = pairs[i] > 0.5;  // counts, up to the rounding of the transforms
        result.values[i] = hasPair ? result.values[i] / pairs[i] / variance
                                   : std::numeric_limits<double>::quiet_NaN();
    }
    return result;
}

/// Distances from no lag to the edge of the central lobe [m].
struct LobeEdge {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    /// To the nearest of its points where nobody knows whether it goes on; infinite: there is none.
    double unknown = std::numeric_limits<double>::infinity();
};

/// Walks over the lags of the lobe, from one to its four neighbors.
class LobeWalk {
public:
    LobeWalk(const Autocorrelation& correlation, double pitchX, double pitchY)
        : correlation_(correlation)
        , pitchX_(pitchX)
        , pitchY_(pitchY)
        , seen_(correlation.values.size(), 0) {}

    LobeEdge edge() {
        visit(0, 0);
        while (!open_.empty()) {
            const Lag lag = open_.back();
            open_.pop_back();
            if (correlation_.isAtBorder(lag.x, lag.y)) {
                edge_.unknown = std::min(edge_.unknown, distance(lag.x, lag.y));
                continue;
            }
            for (const Lag& way : {Lag{1, 0}, Lag{-1, 0}, Lag{0, 1}, Lag{0, -1}}) {
                go(lag, way);
            }
        }
        return edge_;
    }

private:
    struct Lag {
        int x;
        int y;
    };

    [[nodiscard]] double distance(double x, double y) const {
        return std::hypot(x * pitchX_, y * pitchY_);
    }

    void visit(int x, int y) {
        char& seen = seen_[correlation_.index(x, y)];
        if (seen == 0) {
            seen = 1;
            open_.push_back({x, y});
        }
    }

    void go(const Lag& from, const Lag& way) {
        const bool isBelow = from.y + way.y < 0;  // there the opposite lag has the same value
        const int x = isBelow ? -from.x : from.x + way.x;
        const int y = isBelow ? 1 : from.y + way.y;
        const double value = correlation_.values[correlation_.index(x, y)];
        if (std::isnan(value)) {
            edge_.unknown = std::min(edge_.unknown, distance(from.x, from.y));
        } else if (value > kDecayLevel) {
            visit(x, y);
        } else {
            const double inside = correlation_.values[correlation_.index(from.x, from.y)];
            const double share = (inside - kDecayLevel) / (inside - value);
            const double reached = distance(from.x + share * way.x, from.y + share * way.y);
            edge_.shortest = std::min(edge_.shortest, reached);
            edge_.longest = std::max(edge_.longest, reached);
        }
    }

    const Autocorrelation& correlation_;
    double pitchX_;  ///< [m]
    double pitchY_;  ///< [m]
    std::vector<char> seen_;
    std::vector<Lag> open_;
    LobeEdge edge_;
};

}  // namespace

Texture textureOf(const HeightRows& map, const PixelRectangle& pixels, Progress* progress) {
    if (!pixels.liesIn(map.columns, map.rows)) {
        throw Error("the rectangle reaches out of the scan");
    }
    Texture texture;
    texture.step = (std::max(pixels.columns, pixels.rows) - 1) / kLongestSide + 1;
    ProgressPart reading(progress, 0.0, 0.2);
    SampledHeights sampled = sampledHeights(map, pixels, texture.step, &reading);
    subtractMean(sampled);
    ProgressPart transforms(progress, 0.2, 1.0);
    const Autocorrelation correlation = autocorrelationOf(sampled, &transforms);
    if (correlation.values.empty()) {
        return texture;
    }
    const LobeEdge edge =
        LobeWalk(correlation, texture.step * map.pitchX, texture.step * map.pitchY).edge();
    // What lies beyond a point of unknown neighbors is farther away than it.
    if (edge.shortest <= edge.unknown && edge.longest > 0.0) {
        texture.sal = edge.shortest;
        if (std::isinf(edge.unknown)) {
            texture.str = edge.shortest / edge.longest;
        }
    }
    return texture;
}

}  // namespace asperity
