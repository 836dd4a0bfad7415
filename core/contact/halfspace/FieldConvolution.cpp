#include "core/contact/halfspace/FieldConvolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace asperity {

namespace {

using Complex = std::complex<double>;

constexpr int kFactor = 4;  // of all sizes: real transforms are quick for multiples of four

// Columns a power of two apart would share few lines of the cache.
constexpr std::size_t kPadding = 4;

bool hasSmallFactors(int number) noexcept {
    for (const int factor : {2, 3, 5}) {
        while (number % factor == 0) {
            number /= factor;
        }
    }
    return number == 1;
}

std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

/// Displacement at a corner of the rectangle x by y, times pi.
double cornerTerm(double x, double y) noexcept {
    return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

}  // namespace

int fieldSize(int samples) noexcept {
    int size = std::max(kFactor, (samples + kFactor - 1) / kFactor * kFactor);
    while (!hasSmallFactors(size)) {
        size += kFactor;
    }
    return size;
}

struct FieldConvolution::Transform {
    using Fft = Eigen::FFT<double>;
    Fft fft{Fft::impl_type(), static_cast<Fft::Flag>(Fft::Unscaled | Fft::HalfSpectrum)};
};

FieldConvolution::FieldConvolution(int size, int period)
    : size_(size)
    , period_(period)
    , stride_(at(period) + kPadding)
    , transform_(std::make_unique<Transform>())
    , symbol_(at(period / 2 + 1) * stride_)
    , spectrum_(symbol_.size())
    , line_(at(period))
    , row_(at(period)) {}

FieldConvolution::FieldConvolution(FieldConvolution&&) noexcept = default;
FieldConvolution& FieldConvolution::operator=(FieldConvolution&&) noexcept = default;
FieldConvolution::~FieldConvolution() = default;

FieldConvolution FieldConvolution::padded(int size, const EvenFunction& kernel) {
    FieldConvolution convolution(size, 2 * size);
    convolution.setKernel(kernel);
    return convolution;
}

FieldConvolution FieldConvolution::periodic(int size, const EvenFunction& symbol) {
    FieldConvolution convolution(size, size);
    convolution.setSymbol(symbol);
    return convolution;
}

/// The transform of a kernel that is even along both axes is real.
void FieldConvolution::setKernel(const EvenFunction& kernel) {
    const auto mirrored = [this](int index) { return at((period_ - index) % period_); };
    std::vector<double> wrapped(at(period_) * at(period_));
    for (int row = 0; row <= size_; ++row) {
        for (int column = 0; column <= size_; ++column) {
            const double value = kernel(row, column);
            for (const std::size_t y : {at(row), mirrored(row)}) {
                wrapped[y * at(period_) + at(column)] = value;
                wrapped[y * at(period_) + mirrored(column)] = value;
            }
        }
    }
    forwardRows(wrapped, period_);
    const double scale = 1.0 / (static_cast<double>(period_) * period_);
    for (int wave = 0; wave <= period_ / 2; ++wave) {
        transform_->fft.fwd(line_.data(), column(wave), period_);
        std::transform(line_.begin(), line_.end(), symbol_.begin() + (column(wave) - column(0)),
                       [scale](const Complex& value) { return scale * value.real(); });
    }
    std::fill(spectrum_.begin(), spectrum_.end(), Complex());
}

void FieldConvolution::setSymbol(const EvenFunction& symbol) {
    const double scale = 1.0 / (static_cast<double>(period_) * period_);
    for (int wave = 0; wave <= period_ / 2; ++wave) {
        for (int other = 0; other < period_; ++other) {
            symbol_[at(wave) * stride_ + at(other)] =
                scale * symbol(std::min(other, period_ - other), wave);
        }
    }
}

Complex* FieldConvolution::column(int wave) { return spectrum_.data() + at(wave) * stride_; }

/// Transforms the rows of a field into columns of the spectrum.
void FieldConvolution::forwardRows(std::span<const double> field, int rows) {
    const std::size_t width = field.size() / at(rows);
    std::fill(row_.begin(), row_.end(), 0.0);
    for (int row = 0; row < rows; ++row) {
        std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(at(row) * width), width,
                    row_.begin());
        transform_->fft.fwd(line_.data(), row_.data(), period_);
        for (int wave = 0; wave <= period_ / 2; ++wave) {
            column(wave)[row] = line_[at(wave)];
        }
    }
}

void FieldConvolution::inverseRows(std::span<double> result) {
    for (int row = 0; row < size_; ++row) {
        for (int wave = 0; wave <= period_ / 2; ++wave) {
            line_[at(wave)] = column(wave)[row];
        }
        transform_->fft.inv(row_.data(), line_.data(), period_);
        std::copy_n(row_.begin(), size_, result.begin() + static_cast<std::ptrdiff_t>(row) * size_);
    }
}

/// Rows of zeros below the field are neither transformed nor kept: the columns' ends stay zero.
void FieldConvolution::apply(std::span<const double> field, std::span<double> result) {
    forwardRows(field, size_);
    for (int wave = 0; wave <= period_ / 2; ++wave) {
        Complex* const values = column(wave);
        const double* const symbol = symbol_.data() + at(wave) * stride_;
        transform_->fft.fwd(line_.data(), values, period_);
        for (int i = 0; i < period_; ++i) {
            line_[at(i)] *= symbol[i];
        }
        transform_->fft.inv(values, line_.data(), period_);
        std::fill(values + size_, values + period_, Complex());
    }
    inverseRows(result);
}

double loveInfluence(int rows, int columns) noexcept {
    const double below = rows - 0.5;
    const double above = rows + 0.5;
    const double left = columns - 0.5;
    const double right = columns + 0.5;
    return ((cornerTerm(above, right) - cornerTerm(above, left)) -
            (cornerTerm(below, right) - cornerTerm(below, left))) /
           std::numbers::pi;
}

}  // namespace asperity
