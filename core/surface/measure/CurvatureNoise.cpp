#include "core/surface/measure/CurvatureNoise.h"

#include "core/surface/HeightMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

constexpr int kWidth = 5;
constexpr std::array<double, kWidth> kDifference{1.0, -4.0, 6.0, -4.0, 1.0};
constexpr double kSquares = 70.0;  // sum of their squares

/// Fourth difference along both axes from a pixel on, in standard deviations of a height [m]; NaN
/// where a height is missing.
template <class Map>
double differenceAt(const Map& map, int row, int column) {
    double sum = 0.0;
    for (int i = 0; i < kWidth; ++i) {
        for (int j = 0; j < kWidth; ++j) {
            const double height = map.isValid(row + i, column + j)
                                      ? map.at(row + i, column + j)
                                      : std::numeric_limits<double>::quiet_NaN();
            sum += kDifference[static_cast<std::size_t>(i)] *
                   kDifference[static_cast<std::size_t>(j)] * height;
        }
    }
    return sum / kSquares;
}

template <class Map>
double noiseOf(const Map& map) {
    constexpr double kMedian = 0.67448975019608171;  // of a normal variable's magnitude
    constexpr double kPositions = 65536.0;
    const int rows = map.rows - kWidth + 1;
    const int columns = map.columns - kWidth + 1;
    if (rows < 1 || columns < 1) {
        return 0.0;
    }
    const double share = static_cast<double>(rows) * columns / kPositions;
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
    std::vector<double> found;
    for (int row = 0; row < rows; row += step) {
        for (int column = 0; column < columns; column += step) {
            const double difference = differenceAt(map, row, column);
            if (isFiniteHeight(difference)) {
                found.push_back(std::abs(difference));
            }
        }
    }
    if (found.empty()) {
        return 0.0;
    }
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::ranges::nth_element(found, middle);
    return *middle / kMedian;
}

constexpr double kNormalMedian = 0.67448975019608171;  // of a normal variable's magnitude
constexpr int kEvery = 2;  // every other position along both axes counts: neighbors say the same

/// Weights of the samples around a pixel's center for value and second derivative of the spline
/// through the smoothed samples, from the middle to one side. Times the pitch squared.
struct LineKernel {
    std::vector<double> value;
    std::vector<double> bend;
};

double weightAt(const std::vector<double>& half, std::ptrdiff_t distance) {
    const auto k = static_cast<std::size_t>(std::abs(distance));
    return k < half.size() ? half[k] : 0.0;
}

/// The spline passes through the smoothed samples; its second derivative at a knot is their second
/// difference behind the spline's prefilter, sqrt(3) (sqrt(3) - 2)^|k|.
LineKernel lineKernel(double sigma) {
    constexpr std::ptrdiff_t kDecay = 12;  // below 1e-6 there
    LineKernel kernel{.value = halfGaussian(sigma), .bend = {}};
    const std::vector<double>& gaussian = kernel.value;
    const auto difference = [&gaussian](std::ptrdiff_t k) {
        return weightAt(gaussian, k - 1) - (2.0 * weightAt(gaussian, k)) +
               weightAt(gaussian, k + 1);
    };
    const auto reach = static_cast<std::ptrdiff_t>(gaussian.size()) + kDecay;
    for (std::ptrdiff_t k = 0; k < reach; ++k) {
        double sum = difference(k);
        double weight = 1.0;
        for (std::ptrdiff_t j = 1; j <= kDecay; ++j) {
            weight *= std::numbers::sqrt3 - 2.0;
            sum += weight * (difference(k - j) + difference(k + j));
        }
        kernel.bend.push_back(std::numbers::sqrt3 * sum);
    }
    return kernel;
}

/// Scalar product of two whole kernels.
double kernelProduct(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = a[0] * b[0];
    for (std::size_t k = 1; k < std::min(a.size(), b.size()); ++k) {
        sum += 2.0 * a[k] * b[k];
    }
    return sum;
}

/// The fit's kernels along both axes.
struct FitKernel {
    LineKernel x;
    LineKernel y;

    explicit FitKernel(const Smoothing& smoothing)
        : x(lineKernel(smoothing.x)), y(lineKernel(smoothing.y)) {}
};

/// Covariance of the mean curvatures of two fits by white noise of 1 m [1/m^4].
double covariance(const FitKernel& a, const FitKernel& b, double pitchX, double pitchY) {
    const double x = pitchX * pitchX;
    const double y = pitchY * pitchY;
    const double alongX =
        kernelProduct(a.x.bend, b.x.bend) * kernelProduct(a.y.value, b.y.value) / (x * x);
    const double alongY =
        kernelProduct(a.x.value, b.x.value) * kernelProduct(a.y.bend, b.y.bend) / (y * y);
    const double mixed = (kernelProduct(a.x.bend, b.x.value) * kernelProduct(a.y.value, b.y.bend)) +
                         (kernelProduct(a.x.value, b.x.bend) * kernelProduct(a.y.bend, b.y.value));
    return 0.25 * (alongX + alongY + (mixed / (x * y)));
}

/// Numbers in rows.
struct NumberGrid {
    int rows = 0;
    int columns = 0;
    std::vector<double> values;

    [[nodiscard]] double* row(int index) {
        return values.data() +
               (static_cast<std::size_t>(index) * static_cast<std::size_t>(columns));
    }
    [[nodiscard]] const double* row(int index) const {
        return values.data() +
               (static_cast<std::size_t>(index) * static_cast<std::size_t>(columns));
    }
};

NumberGrid emptyNumbers(int rows, int columns) {
    return {
        rows, columns,
        std::vector<double>(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))};
}

NumberGrid transposed(const NumberGrid& field) {
    NumberGrid turned = emptyNumbers(field.columns, field.rows);
    for (int row = 0; row < field.rows; ++row) {
        for (int column = 0; column < field.columns; ++column) {
            turned.row(column)[row] = field.row(row)[column];
        }
    }
    return turned;
}

/// Rows behind a kernel, at every kEvery-th column; beyond their ends as the fit continues them.
NumberGrid behindKernel(const NumberGrid& field, const std::vector<double>& half) {
    const int reach = static_cast<int>(half.size()) - 1;
    NumberGrid result = emptyNumbers(field.rows, (field.columns + kEvery - 1) / kEvery);
    std::vector<double> line(static_cast<std::size_t>(field.columns + (2 * reach)));
    for (int row = 0; row < field.rows; ++row) {
        const double* values = field.row(row);
        for (int i = 0; i < static_cast<int>(line.size()); ++i) {
            const ReflectedSample sample = reflectedSample(field.columns, i - reach);
            line[static_cast<std::size_t>(i)] = (sample.own * values[sample.index]) +
                                                (sample.first * values[0]) +
                                                (sample.last * values[field.columns - 1]);
        }
        for (int column = 0; column < result.columns; ++column) {
            const double* center = line.data() + reach + (kEvery * column);
            double sum = half[0] * center[0];
            for (int k = 1; k <= reach; ++k) {
                sum += half[static_cast<std::size_t>(k)] * (center[k] + center[-k]);
            }
            result.row(row)[column] = sum;
        }
    }
    return result;
}

/// Mean curvature at every kEvery-th pixel along both axes, by columns [1/m].
NumberGrid meanCurvature(const NumberGrid& heights, const FitKernel& kernel, double pitchX,
                         double pitchY) {
    NumberGrid sum = behindKernel(transposed(behindKernel(heights, kernel.x.bend)), kernel.y.value);
    const NumberGrid other =
        behindKernel(transposed(behindKernel(heights, kernel.x.value)), kernel.y.bend);
    for (std::size_t i = 0; i < sum.values.size(); ++i) {
        sum.values[i] =
            0.5 * ((sum.values[i] / (pitchX * pitchX)) + (other.values[i] / (pitchY * pitchY)));
    }
    return sum;
}

/// Fourth differences from one row to the next, in standard deviations of white noise.
NumberGrid differencesAcrossRows(const NumberGrid& heights) {
    static const double kScale = 1.0 / std::sqrt(70.0);  // sum of the squares of 1 4 6 4 1
    NumberGrid result = emptyNumbers(heights.rows - 4, heights.columns);
    for (int row = 0; row < result.rows; ++row) {
        for (int column = 0; column < result.columns; ++column) {
            const auto height = [&](int i) { return heights.row(row + i)[column]; };
            result.row(row)[column] =
                kScale *
                (height(0) + height(4) - (4.0 * (height(1) + height(3))) + (6.0 * height(2)));
        }
    }
    return result;
}

/// Collects magnitudes, and says of what normal variable they are.
class NormalSpread {
public:
    void add(double value) { values_.push_back(std::abs(value)); }
    [[nodiscard]] double variance() {
        if (values_.empty()) {
            return 0.0;
        }
        const auto middle = values_.begin() + static_cast<std::ptrdiff_t>(values_.size() / 2);
        std::ranges::nth_element(values_, middle);
        return *middle * *middle / (kNormalMedian * kNormalMedian);
    }

private:
    std::vector<double> values_;
};

/// First pixel of each part along an axis, and how many pixels it has.
std::pair<std::vector<int>, int> partsOf(int pixels, bool isLarge) {
    constexpr int kParts = 4;
    constexpr int kSide = 64;
    if (!isLarge || pixels <= kSide) {
        return {std::vector<int>{0}, pixels};
    }
    std::vector<int> firsts;
    for (int i = 0; i < kParts; ++i) {
        firsts.push_back(
            static_cast<int>(static_cast<long long>(pixels - kSide) * i / (kParts - 1)));
    }
    return {firsts, kSide};
}

template <class Map>
HeightMap cutOut(const Map& map, int firstRow, int rows, int firstColumn, int columns) {
    HeightMap part{.columns = columns, .rows = rows, .pitchX = map.pitchX, .pitchY = map.pitchY};
    for (int row = firstRow; row < firstRow + rows; ++row) {
        for (int column = firstColumn; column < firstColumn + columns; ++column) {
            const bool isThere = map.isValid(row, column) && isFiniteHeight(map.at(row, column));
            part.heights.push_back(isThere ? map.at(row, column)
                                           : std::numeric_limits<double>::quiet_NaN());
        }
    }
    return part;
}

bool holdsAny(const HeightMap& map) {
    return std::ranges::any_of(map.heights, [](double height) { return isFiniteHeight(height); });
}

}  // namespace

double heightNoise(const HeightMap& map) { return noiseOf(map); }

double heightNoise(const ScanMap& map) { return noiseOf(map); }

template <class Map>
CurvatureNoise::CurvatureNoise(const Map& map, double heightNoise)
    : pitchX_(map.pitchX)
    , pitchY_(map.pitchY)
    , white_(heightNoise > 0.0 ? heightNoise : asperity::heightNoise(map))
    , isKnown_(heightNoise > 0.0) {
    constexpr std::size_t kWhole = 65536;  // pixels of a scan that is not taken in parts
    const bool isLarge = map.heights.size() > kWhole;
    const auto [rows, height] = partsOf(map.rows, isLarge);
    const auto [columns, width] = partsOf(map.columns, isLarge);
    for (const int row : rows) {
        for (const int column : columns) {
            HeightMap part = cutOut(map, row, height, column, width);
            if (holdsAny(part)) {
                part = withInvalidPixelsFilled(std::move(part));
                parts_.push_back({height, width, std::move(part.heights), std::move(part.invalid)});
            }
        }
    }
}

template CurvatureNoise::CurvatureNoise(const HeightMap& map, double heightNoise);
template CurvatureNoise::CurvatureNoise(const ScanMap& map, double heightNoise);

double CurvatureNoise::differencesNoise(const Smoothing& smoothing, bool acrossRows) const {
    const FitKernel kernel(smoothing);
    const LineKernel& along = acrossRows ? kernel.x : kernel.y;
    const LineKernel& across = acrossRows ? kernel.y : kernel.x;
    const double pitchAlong = acrossRows ? pitchX_ : pitchY_;
    const double pitchAcross = acrossRows ? pitchY_ : pitchX_;
    NormalSpread bends;
    NormalSpread values;
    for (const Part& part : parts_) {
        const NumberGrid heights{part.rows, part.columns, part.heights};
        const NumberGrid field = acrossRows ? heights : transposed(heights);
        if (field.rows <= 4) {
            continue;
        }
        const NumberGrid differences = differencesAcrossRows(field);
        for (const double bend : behindKernel(differences, along.bend).values) {
            bends.add(bend);
        }
        for (const double value : behindKernel(differences, along.value).values) {
            values.add(value);
        }
    }
    return 0.25 * ((bends.variance() * kernelProduct(across.value, across.value) /
                    std::pow(pitchAlong, 4)) +
                   (values.variance() * kernelProduct(across.bend, across.bend) /
                    std::pow(pitchAcross, 4)));
}

double CurvatureNoise::noise(const Smoothing& smoothing) const {
    const FitKernel kernel(smoothing);
    const double white = white_ * white_ * covariance(kernel, kernel, pitchX_, pitchY_);
    if (isKnown_) {
        return std::sqrt(white);
    }
    // Both differences show the same of white noise.
    const double more = differencesNoise(smoothing, true) - differencesNoise(smoothing, false);
    return std::sqrt(white + std::max(0.0, more));
}

double CurvatureNoise::blur(const Smoothing& smoothing, double noise) const {
    const FitKernel kernel(smoothing);
    const Smoothing twice{.x = std::numbers::sqrt2 * smoothing.x,
                          .y = std::numbers::sqrt2 * smoothing.y};
    const FitKernel wider(twice);
    NormalSpread changes;
    for (const Part& part : parts_) {
        const NumberGrid heights{part.rows, part.columns, part.heights};
        const NumberGrid before = meanCurvature(heights, kernel, pitchX_, pitchY_);
        const NumberGrid after = meanCurvature(heights, wider, pitchX_, pitchY_);
        for (int column = 0; column < before.rows; ++column) {
            for (int row = 0; row < before.columns; ++row) {
                const auto pixel = (static_cast<std::size_t>(row) * kEvery *
                                    static_cast<std::size_t>(part.columns)) +
                                   (static_cast<std::size_t>(column) * kEvery);
                if (part.invalid.empty() || !part.invalid[pixel]) {
                    changes.add(after.row(column)[row] - before.row(column)[row]);
                }
            }
        }
    }
    const double own = covariance(kernel, kernel, pitchX_, pitchY_);
    const double share = (own + covariance(wider, wider, pitchX_, pitchY_) -
                          (2.0 * covariance(kernel, wider, pitchX_, pitchY_))) /
                         own;
    return std::sqrt(std::max(0.0, changes.variance() - (share * noise * noise)));
}

double CurvatureNoise::heightNoise(const Smoothing& smoothing, double noise) const {
    const FitKernel kernel(smoothing);
    return noise / std::sqrt(covariance(kernel, kernel, pitchX_, pitchY_));
}

}  // namespace asperity
