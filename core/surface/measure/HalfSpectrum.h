#pragma once

#include "core/Progress.h"

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// Discrete Fourier transform of a real field, row by row and then column by column: one half, as
/// opposite waves are conjugate. Rows and columns are padded with zeros to powers of two. Without
/// scale: transforms back are larger by the number of samples. For one thread at a time.
class HalfSpectrum {
public:
    using Complex = std::complex<double>;

    /// @param columns, rows that the field has at most
    HalfSpectrum(int columns, int rows);
    ~HalfSpectrum();
    HalfSpectrum(const HalfSpectrum&) = delete;
    HalfSpectrum& operator=(const HalfSpectrum&) = delete;

    [[nodiscard]] int periodX() const { return periodX_; }
    [[nodiscard]] int periodY() const { return periodY_; }
    /// Waves along x: 0 .. periodX / 2.
    [[nodiscard]] int waves() const { return periodX_ / 2 + 1; }

    /// All rows are zero.
    void clear();
    /// Transforms a row of the field along x.
    void setRow(int row, std::span<const double> values);
    /// Transforms a column of waves along y. @return periodY values, until the next call
    [[nodiscard]] std::span<Complex> transformColumn(int wave);
    /// Transforms what transformColumn() returned back along y, as it is now.
    void returnColumn(int wave);
    /// Transforms a row back along x. @return periodX values, until the next call
    [[nodiscard]] std::span<const double> row(int row);

private:
    struct Transform;
    [[nodiscard]] Complex* column(int wave);

    int periodX_;
    int periodY_;
    std::size_t stride_;  ///< from one column of the spectrum to the next
    std::unique_ptr<Transform> transform_;
    std::vector<double> row_;
    std::vector<Complex> line_;      ///< one row's or column's transform
    std::vector<Complex> spectrum_;  ///< waves() columns
};

/// Reports how far a loop is, some twenty times. @throw Canceled
void reportLoop(Progress* progress, int done, int all);

}  // namespace asperity
