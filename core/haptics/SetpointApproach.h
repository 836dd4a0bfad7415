#pragma once

#include "core/Vector.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity {

/// How an AFM engages at one place: down, stop at a force, dwell, up again.
struct ApproachPlan {
    double setpoint = 5e-9;    ///< force along z above the baseline that ends the descent [N]
    double speed = 10e-9;      ///< of the base, down and up [m/s]
    double baseline = 0.1;     ///< for which the base rests first, to measure force and noise [s]
    double dwell = 0.5;        ///< at the setpoint; infinity: until another device takes over [s]
    double maxDescent = 1e-7;  ///< without a contact the descent ends here [m]
};

/// How long a tip may have no equilibrium: 50 ms, however the steps were rounded [s].
inline constexpr double kMaxUnsolved = 0.0499;

enum class ApproachPhase : std::uint8_t { Baseline, Descent, Dwell, Retract, Done };

/// The deviation and mean of values that come one by one.
class RunningMoments {
public:
    void add(double value) noexcept;
    [[nodiscard]] double mean() const noexcept { return mean_; }
    [[nodiscard]] double deviation() const noexcept;

private:
    long count_ = 0;
    double mean_ = 0.0;
    double squares_ = 0.0;  ///< sum of the squared distances from the mean
};

/// The mean of the last values that come one by one.
class RecentMean {
public:
    static constexpr std::size_t kMaxLength = 256;

    /// @param length of the mean, up to kMaxLength
    explicit RecentMean(std::size_t length = 1) noexcept;
    void add(double value) noexcept;
    /// Whether there have been enough values.
    [[nodiscard]] bool isFull() const noexcept { return count_ >= length_; }
    /// Of the last values; of all where there have not been enough.
    [[nodiscard]] double mean() const noexcept;
    /// How many values the mean goes over.
    [[nodiscard]] std::size_t length() const noexcept { return length_; }

private:
    std::array<double, kMaxLength> values_{};
    std::size_t length_;
    std::size_t count_ = 0;
};

/// Moves the base straight down until the estimated force reaches a setpoint, and up again. It
/// compares the mean over as many ticks as keep the noise, measured at rest, below a sixth of the
/// setpoint, so that noise alone does not end the descent. Where the tip has no equilibrium the
/// descent ends. No allocation, no lock.
class SetpointApproach {
public:
    /// @param start of the base, out of the sample's reach, world [m]
    SetpointApproach(const ApproachPlan& plan, const Vector3& start) noexcept
        : plan_(plan), start_(start) {}

    /// Where the base is after one more time step, world [m].
    /// @param force estimated in the tick before, along z [N]
    /// @param hasEquilibrium whether the tip had one then
    Vector3 advance(double timeStep, double force, bool hasEquilibrium = true) noexcept;

    [[nodiscard]] ApproachPhase phase() const noexcept { return phase_; }
    /// Whether the force has reached the setpoint.
    [[nodiscard]] bool hasEngaged() const noexcept { return engaged_; }
    /// Whether the descent ended where the tip had no equilibrium, for as long as is a fault to the
    /// loop, kMaxUnsolved.
    [[nodiscard]] bool isBlocked() const noexcept { return unsolved_ >= kMaxUnsolved; }
    /// Whether the force at the setpoint has been measured, over as many ticks as are compared.
    [[nodiscard]] bool hasMeasured() const noexcept { return engaged_ && recent_.isFull(); }
    /// That force above the baseline [N]: what is there, which may exceed the setpoint.
    [[nodiscard]] double measuredForce() const noexcept { return recent_.mean() - free_.mean(); }
    /// Standard deviation of that by the noise at rest [N].
    [[nodiscard]] double measuredDeviation() const noexcept;

private:
    void enter(ApproachPhase phase) noexcept;
    void beginDescent() noexcept;
    void descend(double timeStep, double force) noexcept;
    void retract(double timeStep) noexcept;

    ApproachPlan plan_;
    Vector3 start_;  ///< [m]
    ApproachPhase phase_ = ApproachPhase::Baseline;
    bool started_ = false;  ///< the first step only begins
    bool engaged_ = false;
    double inPhase_ = 0.0;   ///< [s]
    double depth_ = 0.0;     ///< below the start [m]
    double unsolved_ = 0.0;  ///< for how long the tip has had no equilibrium [s]
    RunningMoments free_;    ///< force at rest [N]
    RecentMean recent_;      ///< force of late, in the dwell that since its beginning [N]
};

}  // namespace asperity
