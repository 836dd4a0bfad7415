#include "core/surface/measure/HalfSpectrum.h"

#include <algorithm>
#include <bit>
#include <unsupported/Eigen/FFT>

namespace asperity {

namespace {

constexpr int kShortest = 4;         // real transforms are of multiples of four
constexpr std::size_t kPadding = 4;  // columns 2^n apart would share lines of the cache
constexpr int kLoopReports = 20;     // of the progress of each loop

int paddedLength(int samples) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(samples, kShortest))));
}

}  // namespace

struct HalfSpectrum::Transform {
    using Fft = Eigen::FFT<double>;
    Fft fft{Fft::impl_type(), static_cast<Fft::Flag>(Fft::Unscaled | Fft::HalfSpectrum)};
};

HalfSpectrum::HalfSpectrum(int columns, int rows)
    : periodX_(paddedLength(columns))
    , periodY_(paddedLength(rows))
    , stride_(static_cast<std::size_t>(periodY_) + kPadding)
    , transform_(std::make_unique<Transform>())
    , row_(static_cast<std::size_t>(periodX_))
    , line_(static_cast<std::size_t>(std::max(periodX_, periodY_)))
    , spectrum_(static_cast<std::size_t>(waves()) * stride_) {}

HalfSpectrum::~HalfSpectrum() = default;

HalfSpectrum::Complex* HalfSpectrum::column(int wave) {
    return spectrum_.data() + static_cast<std::size_t>(wave) * stride_;
}

void HalfSpectrum::clear() { std::ranges::fill(spectrum_, Complex()); }

void HalfSpectrum::setRow(int row, std::span<const double> values) {
    std::fill(std::ranges::copy(values, row_.begin()).out, row_.end(), 0.0);
    transform_->fft.fwd(line_.data(), row_.data(), periodX_);
    for (int wave = 0; wave < waves(); ++wave) {
        column(wave)[row] = line_[static_cast<std::size_t>(wave)];
    }
}

std::span<HalfSpectrum::Complex> HalfSpectrum::transformColumn(int wave) {
    transform_->fft.fwd(line_.data(), column(wave), periodY_);
    return {line_.data(), static_cast<std::size_t>(periodY_)};
}

void HalfSpectrum::returnColumn(int wave) {
    transform_->fft.inv(column(wave), line_.data(), periodY_);
}

std::span<const double> HalfSpectrum::row(int row) {
    for (int wave = 0; wave < waves(); ++wave) {
        line_[static_cast<std::size_t>(wave)] = column(wave)[row];
    }
    transform_->fft.inv(row_.data(), line_.data(), periodX_);
    return row_;
}

void reportLoop(Progress* progress, int done, int all) {
    if (done % (all / kLoopReports + 1) == 0) {
        reportTo(progress, static_cast<double>(done) / all);
    }
}

}  // namespace asperity
