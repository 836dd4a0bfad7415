#pragma once

#include <array>
#include <cstdint>

namespace asperity {

/// Quantiles of a distribution of times.
struct LatencyQuantiles {
    double median = 0.0;   ///< [s]
    double p99 = 0.0;      ///< [s]
    double largest = 0.0;  ///< [s]
};

/// Counts times in steps of a sixteenth of their size, from 1 ns to 17 s, without allocating.
class LatencyHistogram {
public:
    /// A time [s]; those below zero count as zero.
    void add(double seconds) noexcept;
    /// All times of another one.
    void add(const LatencyHistogram& other) noexcept;
    void clear() noexcept { *this = {}; }

    [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
    /// The time that a share of all times does not exceed, rounded up to the step [s]; 0 when
    /// nothing was counted.
    [[nodiscard]] double quantile(double share) const noexcept;
    [[nodiscard]] LatencyQuantiles quantiles() const noexcept;

private:
    static constexpr int kStepBits = 4;
    static constexpr int kOctaves = 34;
    static constexpr int kBuckets = (kOctaves - kStepBits + 1) << kStepBits;

    [[nodiscard]] static int bucketOf(std::uint64_t nanoseconds) noexcept;
    [[nodiscard]] static double upperEdge(int bucket) noexcept;  ///< [s]

    std::array<std::uint32_t, kBuckets> counts_{};
    std::uint64_t count_ = 0;
    double largest_ = 0.0;  ///< [s]
};

}  // namespace asperity
