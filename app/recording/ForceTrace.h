#pragma once

#include "core/haptics/VirtualRun.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// The estimated force on the tip along the outward normal: that of the surface, as the contact
/// model found it [N].
[[nodiscard]] double normalForce(const TickOutput& output) noexcept;
/// Its standard deviation [N].
[[nodiscard]] double normalForceSigma(const TickOutput& output) noexcept;

/// The normal force of a run, tick by tick. A tick in which a fault had switched the force off, or
/// whose force or indentation is not a number, has NaN for both.
class ForceTrace {
public:
    /// The next tick.
    void take(const TickSample& sample);
    /// The same by its numbers. @param time later than that of the tick before [s]
    void add(double time, double force, double indentation);

    [[nodiscard]] std::size_t size() const noexcept { return time_.size(); }
    /// Of the first tick, in the time of the run [s]. There is one.
    [[nodiscard]] double begin() const noexcept { return time_.front(); }
    /// From the first tick to the last one [s].
    [[nodiscard]] double duration() const noexcept {
        return time_.empty() ? 0.0 : time_.back() - time_.front();
    }
    /// Since the first tick [s].
    [[nodiscard]] double sinceBegin(std::size_t tick) const { return time_[tick] - time_.front(); }
    [[nodiscard]] const std::vector<double>& time() const noexcept { return time_; }    ///< [s]
    [[nodiscard]] const std::vector<double>& force() const noexcept { return force_; }  ///< [N]
    /// Positive into the sample; a gap is negative [m].
    [[nodiscard]] const std::vector<double>& indentation() const noexcept { return indentation_; }

private:
    std::vector<double> time_;
    std::vector<double> force_;
    std::vector<double> indentation_;
};

}  // namespace asperity
