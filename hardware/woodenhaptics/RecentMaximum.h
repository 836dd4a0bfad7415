#pragma once

#include <algorithm>

namespace asperity {

/// The largest of the samples of the last one to two seconds, in two halves of a second each.
class RecentMaximum {
public:
    /// @param now when it was taken, not before the last one [s]
    void add(double sample, double now) noexcept {
        if (now - begin_ >= kHalf) {
            older_ = now - begin_ < 2.0 * kHalf ? newer_ : 0.0;
            newer_ = 0.0;
            begin_ = now;
        }
        newer_ = std::max(newer_, sample);
    }

    /// As of the last sample; 0 before the first. Samples are positive.
    [[nodiscard]] double value() const noexcept { return std::max(older_, newer_); }

private:
    static constexpr double kHalf = 1.0;  // [s]

    double begin_ = 0.0;  ///< of the newer half [s]
    double older_ = 0.0;
    double newer_ = 0.0;
};

}  // namespace asperity
