#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/device/HapticDevice.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace asperity {

/// Plan of how an AFM engages at one position: down, stop at a force, dwell, up again.
struct ApproachPlan {
    double setpoint = 5e-9;   ///< force along `axis` above the baseline that ends the descent [N]
    double speed = 10e-9;     ///< of the base, down and up [m/s]
    double stiffness = 14.0;  ///< of the lever along z: no force rises faster but by a jump [N/m]
    double baseline = 0.1;    ///< for which the base rests first, to measure force and noise [s]
    /// At the setpoint, settling included; infinity: until another device takes over [s].
    double dwell = 0.5;
    double maxDescent = 1e-7;  ///< without a contact the descent ends here [m]
    /// Counts the force along z, or with bendingAxis() what the lever's bending shows, which a
    /// feedback holds.
    Vector3 axis = Vector3::UnitZ();
};

/// Longest time that a tip may have no equilibrium: 50 ms, however the steps were rounded [s].
inline constexpr double kMaxUnsolved = 0.0499;

enum class ApproachPhase : std::uint8_t { Baseline, Descent, Settling, Dwell, Retract, Done };

/// The deviation and mean of values that come one by one.
class RunningMoments {
public:
    void add(double value) noexcept;
    [[nodiscard]] long count() const noexcept { return count_; }
    [[nodiscard]] double mean() const noexcept { return mean_; }
    [[nodiscard]] double deviation() const noexcept;
    /// Standard deviation of the mean, if the values are independent; 0: fewer than two values.
    [[nodiscard]] double meanDeviation() const noexcept;

private:
    long count_ = 0;
    double mean_ = 0.0;
    double squares_ = 0.0;  ///< sum of the squared distances from the mean
};

/// The straight line through the last of values that come one by one.
class RecentLine {
public:
    static constexpr std::size_t kMaxLength = 256;

    /// @param length values of the line, up to kMaxLength
    explicit RecentLine(std::size_t length = 1) noexcept;
    void add(double value) noexcept;
    /// Returns whether there have been enough values.
    [[nodiscard]] bool isFull() const noexcept { return count_ >= length_; }
    /// The line at the newest value, where their mean is that of a while ago. They are enough.
    [[nodiscard]] double end() const noexcept;

private:
    std::array<double, kMaxLength> values_{};
    std::size_t length_;
    std::size_t count_ = 0;
};

/// Moves the base straight down until the estimated force reaches a setpoint, and up again.
///
/// The descent compares the end of a straight line through as many ticks as keep its noise, by that
/// measured far from the sample, below a twelfth of the setpoint: noise alone does not end the
/// descent. The first noisy value that reaches the setpoint comes early, though. So the base
/// settles: at rest the force is measured by a mean, until it is known to a hundredth of the
/// setpoint by its own scatter, and the base moves by what is missing, as the force rose over the
/// last half of the way to the setpoint, four times. A mean at rest has no bias, and the force
/// after it none either. A force beyond the setpoint that came by a jump stays. Where the tip has
/// no equilibrium the approach ends. No allocation, no lock.
class SetpointApproach {
public:
    /// @param start of the base, out of the sample's reach, world [m]
    SetpointApproach(const ApproachPlan& plan, const Vector3& start) noexcept
        : plan_(plan), start_(start) {}

    /// Returns where the base is after one more time step, world [m].
    /// @param force estimated in the tick before, along the plan's axis [N]
    /// @param hasEquilibrium whether the tip had one then
    Vector3 advance(double timeStep, double force, bool hasEquilibrium = true) noexcept;

    [[nodiscard]] const Vector3& axis() const noexcept { return plan_.axis; }
    [[nodiscard]] ApproachPhase phase() const noexcept { return phase_; }
    /// Returns whether the force has reached the setpoint, and settled there.
    [[nodiscard]] bool hasEngaged() const noexcept { return engaged_; }
    /// Returns whether the descent ended where the tip had no equilibrium for kMaxUnsolved, which
    /// is a fault to the loop.
    [[nodiscard]] bool isBlocked() const noexcept { return unsolved_ >= kMaxUnsolved; }
    /// Returns whether the force at the setpoint has been measured, by a mean of the dwell alone.
    [[nodiscard]] bool hasMeasured() const noexcept { return engaged_ && isRestKnown(); }
    /// Returns the force above the free one [N]; it may exceed the setpoint.
    [[nodiscard]] double measuredForce() const noexcept { return rest_.mean() - free_.mean(); }
    /// Returns the force far from the sample, the baseline [N].
    [[nodiscard]] double freeForce() const noexcept { return free_.mean(); }
    /// Standard deviation of that by noise, of the mean and of the baseline [N].
    [[nodiscard]] double measuredDeviation() const noexcept;

private:
    void enter(ApproachPhase phase) noexcept;
    void beginDescent() noexcept;
    void descend(double timeStep, double force) noexcept;
    void beginSettling(double timeStep) noexcept;
    void settle(double timeStep, double force) noexcept;
    /// After the first mean at rest. @return whether the base is to move by what is missing
    bool takeSlope() noexcept;
    /// Returns whether the mean at rest is as good as it must be, or covers as much as there is
    /// time for.
    [[nodiscard]] bool isRestKnown() const noexcept;
    void dwell() noexcept;
    void retract(double timeStep) noexcept;

    ApproachPlan plan_;
    Vector3 start_;  ///< [m]
    ApproachPhase phase_ = ApproachPhase::Baseline;
    bool started_ = false;  ///< the first step only begins
    bool engaged_ = false;
    double inPhase_ = 0.0;    ///< [s]
    double depth_ = 0.0;      ///< below the start [m]
    long ticksAbove_ = 0;     ///< of this descent, with more than half of the setpoint
    double halfDepth_ = 0.0;  ///< where the force passed that half [m]
    double slope_ = 0.0;      ///< rise of the force over the depth, from between [N/m]
    double goal_ = 0.0;       ///< depth to which the base settles [m]
    int moves_ = 0;           ///< by what was missing
    double unsolved_ = 0.0;   ///< for how long the tip has had no equilibrium [s]
    RunningMoments free_;     ///< force far from the sample [N]
    RecentLine recent_;       ///< force of late, in the descent [N]
    RunningMoments rest_;     ///< force since the last move, at rest [N]
    long longestRest_ = 1;    ///< ticks
};

/// An approach with the position where it begins.
struct PlannedApproach {
    Vector3 start = Vector3::Zero();  ///< of the base, out of the sample's reach, world [m]
    ApproachPlan plan;
};

/// Depth of the base below first touch at which the force along z is `force` [N], as far as the
/// scene knows its sample [m].
[[nodiscard]] double expectedDepth(const Scene& scene, const Vector3& position, double force);

/// Straight down to a setpoint and up again; by itself at the highest feature of the
/// scan. Speed and distances are such that all of it takes the plan's duration where the sample is
/// about as the scene says.
[[nodiscard]] PlannedApproach planApproach(const Scene& scene, const PathPlan& plan);

/// The movements that are planned on any scene.
enum class PlannedPath : std::uint8_t { Approach, Slide, Raster, Scratch };

struct PlannedPathRow {
    PlannedPath value;
    const char* key;
    const char* name;
    DevicePath (*plan)(const Scene& scene, const PathPlan& plan);  ///< null: planApproach()
};

template <>
inline constexpr auto kEnumTable<PlannedPath> = std::to_array<PlannedPathRow>(
    {{PlannedPath::Approach, "approach", "Approach", nullptr},
     {PlannedPath::Slide, "slide", "Slide", slidePath},
     {PlannedPath::Raster, "raster", "Raster", rasterPath},
     {PlannedPath::Scratch, "scratch", "Slide at high load", scratchPath}});

/// A device that approaches the sample until the estimated force reaches a setpoint. It knows the
/// force of the tick before; what it makes of it is a device position as any other, so that a
/// recording of it replays without it.
class ApproachDevice final : public HapticDevice {
public:
    /// Makes a device for a run that begins with it.
    /// @param positionGain base displacement per device displacement while the device runs
    ApproachDevice(const PlannedApproach& approach, double positionGain);
    /// Makes a device that takes over from another one.
    /// @param leadIn of the base, from where it is to where the approach starts, world [m]
    /// @param start  where that device is, in the device's frame, while the base is where `leadIn`
    ///               begins
    ApproachDevice(DevicePath leadIn, const ApproachPlan& plan, double positionGain, Vector3 start);

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override;
    void observe(const TickOutput& output) noexcept override;

    /// Any thread; wait-free.
    [[nodiscard]] ApproachPhase phase() const noexcept { return phase_; }
    /// Returns whether the force has reached the setpoint. Any thread; wait-free.
    [[nodiscard]] bool hasEngaged() const noexcept { return engaged_; }
    /// Returns whether the descent ended where the tip had no equilibrium, or below the curve that
    /// the instrument plays. Any thread; wait-free.
    [[nodiscard]] bool isBlocked() const noexcept { return blocked_; }
    /// Returns whether the force of the dwell has been measured. Any thread; wait-free.
    [[nodiscard]] bool hasMeasured() const noexcept { return measured_; }
    /// Returns the force above the baseline, along the plan's axis [N]. Any thread; wait-free.
    [[nodiscard]] double measuredForce() const noexcept { return measuredForce_; }
    /// Its standard deviation by noise [N]. Any thread; wait-free.
    [[nodiscard]] double measuredDeviation() const noexcept { return measuredDeviation_; }
    /// Returns the force far from the sample, once the force of the dwell has been measured [N].
    /// Any thread; wait-free.
    [[nodiscard]] double freeForce() const noexcept { return freeForce_; }

private:
    [[nodiscard]] Vector3 nextBase(double timeStep) noexcept;

    DevicePath leadIn_;
    SetpointApproach approach_;
    double positionGain_;
    Vector3 start_;               ///< of the device [m]
    double time_ = 0.0;           ///< along the lead-in [s]
    double force_ = 0.0;          ///< of the last tick, along the plan's axis [N]
    bool hasEquilibrium_ = true;  ///< whether the tip had one in the last tick
    bool started_ = false;        ///< the first step only begins
    std::atomic<ApproachPhase> phase_ = ApproachPhase::Baseline;
    std::atomic<bool> engaged_ = false;
    std::atomic<bool> blocked_ = false;
    std::atomic<bool> measured_ = false;
    std::atomic<double> measuredForce_ = 0.0;
    std::atomic<double> measuredDeviation_ = 0.0;
    std::atomic<double> freeForce_ = 0.0;
};

}  // namespace asperity
