#include "core/Error.h"
#include "core/Random.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace asperity {

namespace {

using Complex = std::complex<double>;

/// Amplitudes of the waves exp(i q.x) of a real periodic map.
class Spectrum {
public:
    explicit Spectrum(const ScanSize& size)
        : size_(size)
        , waves_(static_cast<std::size_t>(size.columns) * static_cast<std::size_t>(size.rows)) {}

    /// Sets amplitude(|q|) with random phases on every wave that is not at the grid's limit.
    template <class Amplitude>
    void fill(Random& random, const Amplitude& amplitude) {
        for (int ky = 0; 2 * ky < size_.rows; ++ky) {
            for (int kx = -(size_.columns - 1) / 2; 2 * kx < size_.columns; ++kx) {
                const bool isFirstOfPair = ky > 0 || kx > 0;
                if (!isFirstOfPair) {
                    continue;
                }
                const double phase = 2.0 * std::numbers::pi * random.uniform();
                const double qx = 2.0 * std::numbers::pi * kx / size_.sizeX;
                const double qy = 2.0 * std::numbers::pi * ky / size_.sizeY;
                const Complex wave = std::polar(amplitude(std::hypot(qx, qy)), phase);
                at(kx, ky) = wave;
                at(-kx, -ky) = std::conj(wave);
            }
        }
    }

    void scaleToRms(double rms) {
        double power = 0.0;
        for (const Complex& wave : waves_) {
            power += std::norm(wave);
        }
        if (power == 0.0) {
            throw Error("the scan holds no wave between the shortest and the longest");
        }
        for (Complex& wave : waves_) {
            wave *= rms / std::sqrt(power);
        }
    }

    /// The map's values: the inverse transform along x, then along y.
    [[nodiscard]] std::vector<double> values() const {
        const auto columns = static_cast<std::size_t>(size_.columns);
        const auto rows = static_cast<std::size_t>(size_.rows);
        Eigen::FFT<double> transform;
        transform.SetFlag(Eigen::FFT<double>::Unscaled);
        std::vector<Complex> halfDone(waves_.size());
        for (std::size_t row = 0; row < rows; ++row) {
            transform.inv(halfDone.data() + row * columns, waves_.data() + row * columns,
                          size_.columns);
        }
        std::vector<double> values(waves_.size());
        std::vector<Complex> line(rows);
        std::vector<Complex> result(rows);
        for (std::size_t column = 0; column < columns; ++column) {
            for (std::size_t row = 0; row < rows; ++row) {
                line[row] = halfDone[row * columns + column];
            }
            transform.inv(result.data(), line.data(), size_.rows);
            for (std::size_t row = 0; row < rows; ++row) {
                values[row * columns + column] = result[row].real();
            }
        }
        return values;
    }

private:
    Complex& at(int kx, int ky) {
        const int column = kx < 0 ? kx + size_.columns : kx;
        const int row = ky < 0 ? ky + size_.rows : ky;
        return waves_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.columns) +
                      static_cast<std::size_t>(column)];
    }

    ScanSize size_;
    std::vector<Complex> waves_;
};

}  // namespace

HeightMap selfAffineMap(const ScanSize& size, const SelfAffine& recipe) {
    HeightMap map = flatMap(size);
    // Waves that fit the limits but for rounding belong to them.
    constexpr double kRounding = 1e-12;
    const double lowest = 2.0 * std::numbers::pi / recipe.longestWave * (1.0 - kRounding);
    const double rollOff = 2.0 * std::numbers::pi / recipe.rollOffWave;
    const double highest = 2.0 * std::numbers::pi / recipe.shortestWave * (1.0 + kRounding);
    Random random(recipe.seed);
    Spectrum spectrum(size);
    spectrum.fill(random, [&](double q) {
        if (q < lowest || q > highest) {
            return 0.0;
        }
        return q < rollOff ? 1.0 : std::pow(q / rollOff, -(1.0 + recipe.hurst));
    });
    spectrum.scaleToRms(recipe.rms);
    map.heights = spectrum.values();
    return map;
}

}  // namespace asperity
