#include "core/io/heightmap/HeightStatistics.h"

#include "core/io/TextValue.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace asperity {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Sums that do not wait for each other: the processor adds several numbers at a time.
constexpr std::size_t kLanes = 8;

/// Adds up term(value) of all values.
template <class Term>
double sumOf(std::span<const double> values, const Term& term) {
    std::array<double, kLanes> sums{};
    std::size_t i = 0;
    for (; i + kLanes <= values.size(); i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            sums[lane] += term(values[i + lane]);
        }
    }
    for (; i < values.size(); ++i) {
        sums[0] += term(values[i]);
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// The statistics of values in one pass: the mean, and the sum of the squares about it. It uses
/// blocks of the same size, so that the result does not depend on the rows. Source: T. F. Chan,
/// G. H. Golub and R. J. LeVeque, "Algorithms for computing the sample variance", Am. Stat. 37
/// (1983) 242, eq. 2.1.
class BlockStatistics {
public:
    void add(std::span<const double> values) {
        given_ += values.size();
        for (const double value : values) {
            block_[filled_] = value;
            filled_ += isFiniteHeight(value) ? 1U : 0U;  // no branch: another one is put in place
            if (filled_ == block_.size()) {
                addBlock();
            }
        }
    }

    HeightStatistics result() {
        addBlock();
        const std::size_t invalid = given_ - valid_;
        if (valid_ == 0) {
            return {kNone, kNone, kNone, kNone, invalid};
        }
        const auto count = static_cast<double>(valid_);
        return {lowest_, highest_, sum_ / count, std::sqrt(squares_ / count), invalid};
    }

private:
    void addBlock() {
        if (filled_ == 0) {
            return;
        }
        const std::span<const double> values(block_.data(), filled_);
        const auto [low, high] = limitsOf(values);
        lowest_ = std::min(lowest_, low);
        highest_ = std::max(highest_, high);
        const auto size = static_cast<double>(filled_);
        const double sum = sumOf(values, [](double value) { return value; });
        const double mean = sum / size;
        const double squares =
            sumOf(values, [mean](double value) { return (value - mean) * (value - mean); });
        const auto before = static_cast<double>(valid_);
        const double step = mean - mean_;
        const double share = size / (before + size);
        squares_ += squares + step * step * before * share;
        mean_ += step * share;
        sum_ += sum;
        valid_ += filled_;
        filled_ = 0;
    }

    static std::pair<double, double> limitsOf(std::span<const double> values) {
        std::array<double, kLanes> low{};
        low.fill(values.front());
        std::array<double, kLanes> high = low;
        std::size_t i = 0;
        for (; i + kLanes <= values.size(); i += kLanes) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                low[lane] = std::min(low[lane], values[i + lane]);
                high[lane] = std::max(high[lane], values[i + lane]);
            }
        }
        for (; i < values.size(); ++i) {
            low[0] = std::min(low[0], values[i]);
            high[0] = std::max(high[0], values[i]);
        }
        return {std::ranges::min(low), std::ranges::max(high)};
    }

    std::array<double, 256> block_{};
    std::size_t filled_ = 0;
    std::size_t given_ = 0;
    std::size_t valid_ = 0;  ///< of the values in whole blocks, as all that follows
    double lowest_ = std::numeric_limits<double>::infinity();
    double highest_ = -std::numeric_limits<double>::infinity();
    double sum_ = 0.0;
    double squares_ = 0.0;
    double mean_ = 0.0;
};

constexpr double kLargest = 65535.0;

}  // namespace

HeightStatistics heightStatistics(const std::function<void(const TakeRow&)>& giveRows) {
    BlockStatistics statistics;
    giveRows([&statistics](std::span<const double> values) { statistics.add(values); });
    return statistics.result();
}

HeightCounts::HeightCounts(const HeightRange& range)
    : zero_(range.lowest), full_(range.highest), marksMissing_(range.missing > 0) {
    if (marksMissing_) {
        zero_ -= (range.highest - range.lowest) / (kLargest - 1.0);
    }
}

std::uint16_t HeightCounts::countOf(double height) const {
    if (!isFiniteHeight(height)) {
        return 0;
    }
    const double share = full_ > zero_ ? (height - zero_) / (full_ - zero_) : 0.0;
    const double count = std::round(kLargest * share);
    return static_cast<std::uint16_t>(std::clamp(count, marksMissing_ ? 1.0 : 0.0, kLargest));
}

std::vector<std::pair<std::string, std::string>> HeightCounts::keys(const std::string& unit) const {
    ImageKeys keys = {
        {"Gwy::ZMin", exactText(zero_)}, {"Gwy::ZMax", exactText(full_)}, {"Gwy::ZUnit", unit}};
    if (marksMissing_) {
        keys.emplace_back(kNoDataKey, "0");
    }
    return keys;
}

}  // namespace asperity
