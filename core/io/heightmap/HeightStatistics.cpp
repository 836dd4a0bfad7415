#include "core/io/heightmap/HeightStatistics.h"

#include "core/surface/HeightMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// The mean of values and the sum of their squares about it, in one pass. It goes by blocks of the
/// same size, so that the result does not depend on the rows. Source: T. F. Chan, G. H. Golub and
/// R. J. LeVeque, "Algorithms for computing the sample variance", Am. Stat. 37 (1983) 242, eq. 2.1.
class Squares {
public:
    void add(double value) {
        block_[filled_] = value;
        if (++filled_ == block_.size()) {
            addBlock();
        }
    }
    /// Returns the sum about the mean of all values.
    double sum() {
        addBlock();
        return squares_;
    }

private:
    void addBlock() {
        if (filled_ == 0) {
            return;
        }
        const auto size = static_cast<double>(filled_);
        double sum = 0.0;
        for (std::size_t i = 0; i < filled_; ++i) {
            sum += block_[i];
        }
        const double mean = sum / size;
        double squares = 0.0;
        for (std::size_t i = 0; i < filled_; ++i) {
            squares += (block_[i] - mean) * (block_[i] - mean);
        }
        const double step = mean - mean_;
        const double share = size / (count_ + size);
        squares_ += squares + step * step * count_ * share;
        mean_ += step * share;
        count_ += size;
        filled_ = 0;
    }

    std::array<double, 256> block_{};
    std::size_t filled_ = 0;
    double count_ = 0.0;  ///< of the values in whole blocks, as the next two
    double mean_ = 0.0;
    double squares_ = 0.0;
};

}  // namespace

HeightStatistics heightStatistics(const std::function<void(const TakeRow&)>& giveRows) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    HeightStatistics result{kNone, kNone, kNone, kNone, 0};
    std::size_t valid = 0;
    double sum = 0.0;
    Squares squares;
    giveRows([&](std::span<const double> values) {
        for (const double value : values) {
            if (isFiniteHeight(value)) {
                result.lowest = valid == 0 ? value : std::min(result.lowest, value);
                result.highest = valid == 0 ? value : std::max(result.highest, value);
                sum += value;
                squares.add(value);
                ++valid;
            } else {
                ++result.invalidPixels;
            }
        }
    });
    if (valid > 0) {
        result.mean = sum / static_cast<double>(valid);
        result.rms = std::sqrt(squares.sum() / static_cast<double>(valid));
    }
    return result;
}

}  // namespace asperity
