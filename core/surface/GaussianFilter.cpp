#include "core/surface/GaussianFilter.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr double kReachInSigmas = 5.0;

/// Weights of the centre and of the pixels on one side of it; the whole kernel sums to 1.
std::vector<double> halfKernel(double sigma) {
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

/// Value of a line continued by point reflection about its end pixels, as often as needed.
double reflected(const double* line, std::ptrdiff_t count, std::ptrdiff_t index) {
    if (count == 1) {
        return line[0];
    }
    const std::ptrdiff_t period = 2 * (count - 1);
    const std::ptrdiff_t turns = (index >= 0 ? index : index - period + 1) / period;
    const std::ptrdiff_t phase = index - turns * period;
    const double climb = 2.0 * static_cast<double>(turns) * (line[count - 1] - line[0]);
    return phase < count ? climb + line[phase]
                         : climb + 2.0 * line[count - 1] - line[period - phase];
}

/// Smooths one line after the other, in place.
void smoothLines(std::vector<double>& values, std::size_t length,
                 const std::vector<double>& kernel) {
    const std::size_t reach = kernel.size() - 1;
    std::vector<double> extended(length + 2 * reach);
    for (std::size_t start = 0; start < values.size(); start += length) {
        double* line = values.data() + start;
        for (std::size_t i = 0; i < extended.size(); ++i) {
            extended[i] =
                reflected(line, static_cast<std::ptrdiff_t>(length),
                          static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(reach));
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

}  // namespace

HeightMap smoothed(const HeightMap& map, double sigmaPixels) {
    requireFinite(map);
    if (!std::isgreaterequal(sigmaPixels, 0.0) || sigmaPixels > kWidestSmoothing) {
        throw Error("the smoothing width must be between 0 and " +
                    std::to_string(static_cast<int>(kWidestSmoothing)) + " pixels");
    }
    HeightMap result = map;
    // Narrower than this, every weight but the centre's rounds to nothing.
    constexpr double kNarrowest = 0.05;
    if (sigmaPixels < kNarrowest) {
        return result;
    }
    const std::vector<double> kernel = halfKernel(sigmaPixels);
    smoothLines(result.heights, static_cast<std::size_t>(map.columns), kernel);
    result.heights = transposed(result.heights, static_cast<std::size_t>(map.columns));
    smoothLines(result.heights, static_cast<std::size_t>(map.rows), kernel);
    result.heights = transposed(result.heights, static_cast<std::size_t>(map.rows));
    return result;
}

}  // namespace asperity
