#include "core/surface/fit/GaussianFilter.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace asperity {

namespace {

/// Smooths lines of one length, in place.
class LineSmoother {
public:
    LineSmoother(int length, double sigma)
        : kernel_(halfGaussian(sigma))
        , length_(static_cast<std::size_t>(length))
        , extended_(length_ + 2 * (kernel_.size() - 1)) {}

    [[nodiscard]] bool isIdentity() const { return kernel_.size() == 1; }

    void smooth(double* line) {
        const std::size_t reach = kernel_.size() - 1;
        for (std::size_t i = 0; i < extended_.size(); ++i) {
            const ReflectedSample sample = reflectedSample(
                static_cast<int>(length_), static_cast<int>(i) - static_cast<int>(reach));
            extended_[i] = sample.own * line[sample.index] + sample.first * line[0] +
                           sample.last * line[length_ - 1];
        }
        const double* center = extended_.data() + reach;
        for (std::size_t i = 0; i < length_; ++i) {
            line[i] = kernel_[0] * center[i];
        }
        for (std::size_t k = 1; k <= reach; ++k) {
            for (std::size_t i = 0; i < length_; ++i) {
                line[i] += kernel_[k] * (center[i + k] + extended_[i + reach - k]);
            }
        }
    }

private:
    std::vector<double> kernel_;
    std::size_t length_;
    std::vector<double> extended_;
};

constexpr int kBlock = 16;  // lines that are taken out together, so that columns share cache lines

/// Smooths rows first, first + 1, ... of the map.
template <class Map>
void smoothRows(Map& map, int first, LineSmoother& smoother) {
    using Height = typename decltype(Map::heights)::value_type;
    std::vector<double> line(static_cast<std::size_t>(map.columns));
    for (int row = first; row < std::min(first + kBlock, map.rows); ++row) {
        Height* heights = map.heights.data() + map.index(row, 0);
        std::copy_n(heights, line.size(), line.begin());
        smoother.smooth(line.data());
        std::ranges::transform(line, heights,
                               [](double height) { return static_cast<Height>(height); });
    }
}

/// Smooths columns first, first + 1, ... of the map.
template <class Map>
void smoothColumns(Map& map, int first, LineSmoother& smoother) {
    using Height = typename decltype(Map::heights)::value_type;
    const auto length = static_cast<std::size_t>(map.rows);
    const auto count = static_cast<std::size_t>(std::min(kBlock, map.columns - first));
    std::vector<double> lines(count * length);
    for (int row = 0; row < map.rows; ++row) {
        const Height* heights = map.heights.data() + map.index(row, first);
        for (std::size_t i = 0; i < count; ++i) {
            lines[i * length + static_cast<std::size_t>(row)] = static_cast<double>(heights[i]);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        smoother.smooth(lines.data() + i * length);
    }
    for (int row = 0; row < map.rows; ++row) {
        Height* heights = map.heights.data() + map.index(row, first);
        for (std::size_t i = 0; i < count; ++i) {
            heights[i] = static_cast<Height>(lines[i * length + static_cast<std::size_t>(row)]);
        }
    }
}

/// Calls smooth(first) for every kBlock lines of `count`.
template <class Smooth>
void forEachBlock(int count, Progress* progress, const Smooth& smooth) {
    constexpr int kReports = 25;
    const int step = (count / kReports / kBlock + 1) * kBlock;
    for (int first = 0; first < count; first += kBlock) {
        if (first % step == 0) {
            reportTo(progress, static_cast<double>(first) / count);
        }
        smooth(first);
    }
}

/// @throw Error naming the first height that is no number
template <class Map>
void requireFinite(const Map& map) {
    requireUsable(map);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (!isFiniteHeight(map.at(row, column))) {
                throw Error("the height at row " + std::to_string(row) + ", column " +
                            std::to_string(column) + " is not a finite number");
            }
        }
    }
}

template <class Map>
void smooth(Map& map, const Smoothing& smoothing, Progress* progress) {
    requireFinite(map);
    LineSmoother alongX(map.columns, smoothing.x);
    LineSmoother alongY(map.rows, smoothing.y);
    if (!alongX.isIdentity()) {
        ProgressPart rows(progress, 0.0, 0.5);
        forEachBlock(map.rows, &rows, [&](int first) { smoothRows(map, first, alongX); });
    }
    if (!alongY.isIdentity()) {
        ProgressPart columns(progress, 0.5, 1.0);
        forEachBlock(map.columns, &columns, [&](int first) { smoothColumns(map, first, alongY); });
    }
}

}  // namespace

std::vector<double> halfGaussian(double sigma) {
    if (!std::isgreaterequal(sigma, 0.0) || sigma > kMaxSmoothing) {
        throw Error("the smoothing width must be between 0 and " +
                    std::to_string(static_cast<int>(kMaxSmoothing)) + " pixels");
    }
    // Narrower than this, every weight but the middle one rounds to nothing.
    constexpr double kMinWidth = 0.05;
    if (sigma < kMinWidth) {
        return {1.0};
    }
    constexpr double kReachInSigmas = 5.0;
    const auto reach = static_cast<std::size_t>(std::ceil(kReachInSigmas * sigma));
    std::vector<double> weights(reach + 1);
    double sum = 0.0;
    for (std::size_t k = 0; k <= reach; ++k) {
        const double distance = static_cast<double>(k) / sigma;
        weights[k] = std::exp(-0.5 * distance * distance);
        sum += k == 0 ? weights[k] : 2.0 * weights[k];
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

ReflectedSample reflectedSample(int samples, int index) {
    if (samples == 1) {
        return {};
    }
    const int period = 2 * (samples - 1);
    const int turns = (index >= 0 ? index : index - period + 1) / period;
    const int phase = index - turns * period;
    const double climb = 2.0 * turns;
    if (phase < samples) {
        return {.index = phase, .own = 1.0, .first = -climb, .last = climb};
    }
    return {.index = period - phase, .own = -1.0, .first = -climb, .last = climb + 2.0};
}

HeightMap smoothed(HeightMap map, const Smoothing& smoothing, Progress* progress) {
    smooth(map, smoothing, progress);
    return map;
}

ScanMap smoothed(ScanMap map, const Smoothing& smoothing, Progress* progress) {
    smooth(map, smoothing, progress);
    return map;
}

}  // namespace asperity
