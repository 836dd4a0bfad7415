#include "core/surface/measure/PowerSpectrum.h"

#include "core/Error.h"
#include "core/surface/measure/HalfSpectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace asperity {

namespace {

/// Hann window whose zeros lie half a sample beyond the ends: one sample alone has all its weight.
std::vector<double> hannWindow(int samples) {
    std::vector<double> window(static_cast<std::size_t>(samples));
    for (std::size_t i = 0; i < window.size(); ++i) {
        const double sine = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / samples);
        window[i] = sine * sine;
    }
    return window;
}

/// Reads the rows of a rectangle.
class WindowedRows {
public:
    WindowedRows(const HeightRows& map, const PixelRectangle& pixels)
        : map_(map)
        , pixels_(pixels)
        , across_(hannWindow(pixels.columns))
        , down_(hannWindow(pixels.rows))
        , row_(static_cast<std::size_t>(map.columns)) {}

    /// Calls visit(row, column, height, weight) for each pixel with data, and ends(row) after each
    /// row.
    template <class Visit, class Ends>
    void forEach(Progress* progress, const Visit& visit, const Ends& ends) {
        for (int row = 0; row < pixels_.rows; ++row) {
            reportLoop(progress, row, pixels_.rows);
            map_.readRow(pixels_.row + row, row_.data());
            for (int column = 0; column < pixels_.columns; ++column) {
                const double height = row_[static_cast<std::size_t>(pixels_.column + column)];
                if (isFiniteHeight(height)) {
                    visit(column, height,
                          across_[static_cast<std::size_t>(column)] *
                              down_[static_cast<std::size_t>(row)]);
                }
            }
            ends(row);
        }
    }

private:
    const HeightRows& map_;
    PixelRectangle pixels_;
    std::vector<double> across_;
    std::vector<double> down_;
    std::vector<double> row_;
};

/// Sums over the heights, counted from the first of them: an offset costs no digits.
struct WindowSums {
    double origin = 0.0;    ///< [m]
    double count = 0.0;     ///< of heights
    double sum = 0.0;       ///< [m]
    double squares = 0.0;   ///< [m^2]
    double weights = 0.0;   ///< of the window
    double weighted = 0.0;  ///< [m]

    void add(double height, double weight) {
        origin = count == 0.0 ? height : origin;
        const double above = height - origin;
        count += 1.0;
        sum += above;
        squares += above * above;
        weights += weight;
        weighted += weight * above;
    }
    /// Sq^2 [m^2].
    [[nodiscard]] double variance() const {
        return std::max(0.0, squares / count - (sum / count) * (sum / count));
    }
    /// Mean under the window [m].
    [[nodiscard]] double mean() const { return origin + weighted / weights; }
};

/// Collects the powers of all waves in rings.
class RingSums {
public:
    RingSums(const HalfSpectrum& spectrum, const HeightRows& map, const PixelRectangle& pixels)
        : columns_(spectrum.periodX())
        , rows_(spectrum.periodY())
        , stepX_(1.0 / (columns_ * map.pitchX))
        , stepY_(1.0 / (rows_ * map.pitchY))
        , width_(1.0 / std::max(pixels.columns * map.pitchX, pixels.rows * map.pitchY))
        , rings_(static_cast<std::size_t>(std::hypot(0.5 / map.pitchX, 0.5 / map.pitchY) / width_ +
                                          0.5) +
                 1) {}

    void add(int wave, std::span<const std::complex<double>> column) {
        const double twice = wave == 0 || 2 * wave == columns_ ? 1.0 : 2.0;
        for (int i = 0; i < rows_; ++i) {
            if (wave == 0 && i == 0) {
                continue;  // the mean, which is none
            }
            const double frequency = std::hypot(wave * stepX_, std::min(i, rows_ - i) * stepY_);
            const double power = twice * std::norm(column[static_cast<std::size_t>(i)]);
            SpectrumRing& ring = ringAt(frequency);
            ring.frequency += twice * frequency;
            ring.density += power;
            ring.waves += twice;
            power_ += power;
        }
    }

    /// @param variance that all waves have together [m^2]
    [[nodiscard]] PowerSpectrum spectrum(double variance) const {
        PowerSpectrum spectrum{.rings = {}, .waveArea = stepX_ * stepY_};
        for (const SpectrumRing& ring : rings_) {
            if (ring.waves > 0.0) {
                spectrum.rings.push_back(
                    {.frequency = ring.frequency / ring.waves,
                     .density = variance / spectrum.waveArea * ring.density / power_ / ring.waves,
                     .waves = ring.waves});
            }
        }
        return spectrum;
    }
    [[nodiscard]] bool isEmpty() const { return !(power_ > 0.0); }

private:
    /// Waves longer than the rectangle, which zeros behind it make, belong to the first ring.
    SpectrumRing& ringAt(double frequency) {
        const auto index = static_cast<std::size_t>(frequency / width_ + 0.5);
        return rings_[std::clamp<std::size_t>(index, 1, rings_.size()) - 1];
    }

    int columns_;
    int rows_;
    double stepX_;  ///< of frequencies [1/m]
    double stepY_;  ///< [1/m]
    double width_;  ///< of a ring [1/m]
    double power_ = 0.0;
    std::vector<SpectrumRing> rings_;  ///< sums
};

}  // namespace

PowerSpectrum powerSpectrumOf(const HeightRows& map, const PixelRectangle& pixels,
                              Progress* progress) {
    if (!pixels.liesIn(map.columns, map.rows)) {
        throw Error("the rectangle reaches out of the scan");
    }
    WindowedRows rows(map, pixels);
    WindowSums sums;
    ProgressPart first(progress, 0.0, 0.2);
    rows.forEach(
        &first, [&](int, double height, double weight) { sums.add(height, weight); }, [](int) {});
    if (sums.count == 0.0) {
        throw Error("no pixel of the rectangle holds data");
    }
    HalfSpectrum spectrum(pixels.columns, pixels.rows);
    std::vector<double> windowed(static_cast<std::size_t>(pixels.columns));
    ProgressPart second(progress, 0.2, 0.6);
    rows.forEach(
        &second,
        [&](int column, double height, double weight) {
            windowed[static_cast<std::size_t>(column)] = weight * (height - sums.mean());
        },
        [&](int row) {
            spectrum.setRow(row, windowed);
            std::ranges::fill(windowed, 0.0);
        });
    RingSums rings(spectrum, map, pixels);
    ProgressPart third(progress, 0.6, 1.0);
    for (int wave = 0; wave < spectrum.waves(); ++wave) {
        reportLoop(&third, wave, spectrum.waves());
        rings.add(wave, spectrum.transformColumn(wave));
    }
    return rings.isEmpty() ? PowerSpectrum() : rings.spectrum(sums.variance());
}

}  // namespace asperity
