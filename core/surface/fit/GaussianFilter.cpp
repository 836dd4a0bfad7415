#include "core/surface/fit/GaussianFilter.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// Smooths one line after the other, in place.
void smoothLines(std::vector<double>& values, std::size_t length,
                 const std::vector<double>& kernel) {
    const std::size_t reach = kernel.size() - 1;
    std::vector<double> extended(length + 2 * reach);
    for (std::size_t start = 0; start < values.size(); start += length) {
        double* line = values.data() + start;
        for (std::size_t i = 0; i < extended.size(); ++i) {
            const ReflectedSample sample = reflectedSample(
                static_cast<int>(length), static_cast<int>(i) - static_cast<int>(reach));
            extended[i] = sample.own * line[sample.index] + sample.first * line[0] +
                          sample.last * line[length - 1];
        }
        const double* centre = extended.data() + reach;
        for (std::size_t i = 0; i < length; ++i) {
            line[i] = kernel[0] * centre[i];
        }
        for (std::size_t k = 1; k <= reach; ++k) {
            for (std::size_t i = 0; i < length; ++i) {
                line[i] += kernel[k] * (centre[i + k] + extended[i + reach - k]);
            }
        }
    }
}

std::vector<double> transposed(const std::vector<double>& values, std::size_t rowLength) {
    constexpr std::size_t kBlock = 16;  // keeps both sides of the copy in the cache
    const std::size_t rows = values.size() / rowLength;
    std::vector<double> result(values.size());
    for (std::size_t top = 0; top < rows; top += kBlock) {
        for (std::size_t left = 0; left < rowLength; left += kBlock) {
            for (std::size_t i = top; i < std::min(top + kBlock, rows); ++i) {
                for (std::size_t j = left; j < std::min(left + kBlock, rowLength); ++j) {
                    result[j * rows + i] = values[i * rowLength + j];
                }
            }
        }
    }
    return result;
}

/// @throw Error naming the first height that is no number
void requireFinite(const HeightMap& map) {
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

}  // namespace

std::vector<double> halfGaussian(double sigma) {
    if (!std::isgreaterequal(sigma, 0.0) || sigma > kWidestSmoothing) {
        throw Error("the smoothing width must be between 0 and " +
                    std::to_string(static_cast<int>(kWidestSmoothing)) + " pixels");
    }
    // Narrower than this, every weight but the middle one rounds to nothing.
    constexpr double kNarrowest = 0.05;
    if (sigma < kNarrowest) {
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

HeightMap smoothed(const HeightMap& map, const Smoothing& smoothing) {
    requireFinite(map);
    const std::vector<double> alongX = halfGaussian(smoothing.x);
    const std::vector<double> alongY = halfGaussian(smoothing.y);
    HeightMap result = map;
    if (alongX.size() > 1) {
        smoothLines(result.heights, static_cast<std::size_t>(map.columns), alongX);
    }
    if (alongY.size() > 1) {
        result.heights = transposed(result.heights, static_cast<std::size_t>(map.columns));
        smoothLines(result.heights, static_cast<std::size_t>(map.rows), alongY);
        result.heights = transposed(result.heights, static_cast<std::size_t>(map.rows));
    }
    return result;
}

}  // namespace asperity
