#include "core/realtime/LatencyHistogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace asperity {

// Times below 2^kStepBits ns have a bucket each; above, every octave has 2^kStepBits of them.
int LatencyHistogram::bucketOf(std::uint64_t nanoseconds) noexcept {
    const int octave = std::bit_width(nanoseconds) - 1;
    if (octave < kStepBits) {
        return static_cast<int>(nanoseconds);
    }
    const int shift = octave - kStepBits;
    const int step = static_cast<int>(nanoseconds >> shift) - (1 << kStepBits);
    return std::min(((shift + 1) << kStepBits) + step, kBuckets - 1);
}

double LatencyHistogram::upperEdge(int bucket) noexcept {
    const int row = bucket >> kStepBits;
    const int step = bucket & ((1 << kStepBits) - 1);
    if (row == 0) {
        return step * 1e-9;
    }
    const auto first = static_cast<std::uint64_t>((1 << kStepBits) + step + 1) << (row - 1);
    return static_cast<double>(first - 1) * 1e-9;
}

void LatencyHistogram::add(double seconds) noexcept {
    const double time = std::max(seconds, 0.0);
    constexpr double kMaxTime = 17.0;
    const double nanoseconds = std::min(time, kMaxTime) * 1e9;
    ++counts_[static_cast<std::size_t>(bucketOf(static_cast<std::uint64_t>(nanoseconds)))];
    ++count_;
    largest_ = std::max(largest_, time);
}

void LatencyHistogram::add(const LatencyHistogram& other) noexcept {
    for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
        counts_[bucket] += other.counts_[bucket];
    }
    count_ += other.count_;
    largest_ = std::max(largest_, other.largest_);
}

double LatencyHistogram::quantile(double share) const noexcept {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
    std::uint64_t seen = 0;
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        seen += counts_[static_cast<std::size_t>(bucket)];
        if (seen >= wanted && seen > 0) {
            return std::min(upperEdge(bucket), largest_);
        }
    }
    return largest_;
}

LatencyQuantiles LatencyHistogram::quantiles() const noexcept {
    return {.median = quantile(0.5), .p99 = quantile(0.99), .largest = largest_};
}

}  // namespace asperity
