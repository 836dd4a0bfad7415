#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/haptics/device/HapticDevice.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace asperity {

struct Scene;

/// Limits of a feedback's gain. On a steep slope a tilted lever is stiffer to the base than along
/// z: at the largest gain up to twice as stiff is stable.
inline constexpr double kMinFeedbackGain = 0.02;
inline constexpr double kMaxFeedbackGain = 0.8;
inline constexpr double kDefaultFeedbackGain = 0.65;

/// What a z feedback holds, and within which heights.
struct FeedbackPlan {
    double setpoint = 5e-9;   ///< force along z above the free one, as the bending shows it [N]
    double freeForce = 0.0;   ///< measured far from the sample [N]
    double stiffness = 14.0;  ///< of the lever along z [N/m]
    /// Stiffness of lever and contact in series over the lever's: the softer the contact, the
    /// slower a slope is learned.
    double seriesShare = 1.0;
    double lowest = 0.0;              ///< height of the base [m]
    double highest = 0.0;             ///< same [m]
    Vector3 axis = Vector3::UnitZ();  ///< see bendingAxis()
};

/// Plans to hold a force on any part of a scan: the range leaves the tip free above the highest
/// height, and presses twice as deep as the scene expects below the lowest.
/// @param base where the base is, world [m] @param setpoint, freeForce as FeedbackPlan has them
[[nodiscard]] FeedbackPlan planFeedback(const Scene& scene, const Vector3& base, double setpoint,
                                        double freeForce);

enum class FeedbackState : std::uint8_t {
    Holding,
    ContactLost,  ///< no tenth of the setpoint for kContactTimeout: the base descends
    RangeLeft,    ///< the base is at its lowest or highest, and the force is not the setpoint
};

template <>
inline constexpr auto kEnumTable<FeedbackState> =
    std::to_array<NamedRow<FeedbackState>>({{FeedbackState::Holding, "force held"},
                                            {FeedbackState::ContactLost, "contact lost"},
                                            {FeedbackState::RangeLeft, "z range left"}});

/// Holds the bending by the height of the base, as an AFM in contact mode does: the force along z
/// that it shows. Friction along the lever bends it, too, by a few percent of that force.
///
/// A proportional part takes the share `gain` of the error in a tick. It alone would lag on a slope
/// by the rise of many ticks, so an integral part learns the speed at which the base has to rise:
/// with the share r of FeedbackPlan, q = (1 - sqrt(1 - r g))^2 / r gives both poles the value
/// a = sqrt(1 - r g). A slope then leaves no error; on a stiff sample, n ticks after it begins, the
/// error is n a^(n-1) times that of one tick, 1.2 times at most for a gain of 0.65. Out of contact
/// the force says nothing of a slope, and the speed is forgotten.
///
/// While the tip rests on the sample there is no slope to learn: the speed is forgotten, and so
/// small a gain corrects that noise does not turn the friction at each tick. No allocation, no
/// lock.
class ZFeedback {
public:
    /// Without contact for so long the contact is lost [s].
    static constexpr double kContactTimeout = 0.1;

    explicit ZFeedback(const FeedbackPlan& plan) noexcept : plan_(plan) {}

    /// Returns the height of the base after one more time step [m].
    /// @param force  along z, as the bending showed it in the tick before [N]
    /// @param height of the base in that tick [m]: where it did not follow, nothing is learned
    /// @param moves  whether the tip moves along the sample
    double advance(double timeStep, double force, double height, double gain, bool moves) noexcept;

    void setSetpoint(double setpoint) noexcept { plan_.setpoint = setpoint; }
    [[nodiscard]] FeedbackState state() const noexcept { return state_; }
    /// Force of the tick before, less free force and setpoint [N].
    [[nodiscard]] double error() const noexcept { return error_; }

private:
    FeedbackPlan plan_;
    double height_ = 0.0;  ///< in the tick before the last [m]
    double wanted_ = 0.0;  ///< after it [m]
    double speed_ = 0.0;   ///< learned [m per tick]
    double error_ = 0.0;   ///< [N]
    double lost_ = 0.0;    ///< for how long there has been no contact [s]
    FeedbackState state_ = FeedbackState::Holding;
};

/// A device that moves along the sample as another one does, while a feedback sets its height. What
/// it makes of the force is a device position as any other: a recording of it replays without it.
///
/// A device that mouse and keyboard pilot waits while the force is above twice the setpoint, and is
/// no faster than that one tick on a slope of 45 degrees costs the setpoint. One that follows a
/// path keeps its times, and stops for good where the force is not held any more.
class FeedbackDevice final : public HapticDevice {
public:
    /// Makes a device that takes over from another one.
    /// @param lateral      moves the tip along the sample; its height counts for nothing
    /// @param height       of the base now [m]
    /// @param positionGain base displacement per device displacement while the device runs
    FeedbackDevice(std::unique_ptr<HapticDevice> lateral, const FeedbackPlan& plan, double height,
                   double positionGain);

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override;
    void observe(const TickOutput& output) noexcept override;
    [[nodiscard]] PilotedDevice* piloted() noexcept override { return lateral_->piloted(); }

    /// Any thread; wait-free. @param setpoint [N] @param gain kMinFeedbackGain to kMaxFeedbackGain
    void hold(double setpoint, double gain) noexcept;
    /// Any thread; wait-free.
    [[nodiscard]] FeedbackState state() const noexcept { return state_; }
    /// Returns the force above free force and setpoint, as the bending shows it [N]. Any thread;
    /// wait-free.
    [[nodiscard]] double error() const noexcept { return error_; }
    /// Returns the force that is held [N]. Any thread; wait-free.
    [[nodiscard]] double setpoint() const noexcept { return setpoint_; }
    /// Returns the error of a tick, as error() of the tick after it has it [N]. Any thread;
    /// wait-free.
    [[nodiscard]] double errorOf(const TickOutput& output) const noexcept {
        return axis_.dot(output.estimate.force) - freeForce_ - setpoint_;
    }
    /// Returns the speed along the sample that mouse and keyboard are held to, of the device [m/s].
    /// Any thread; wait-free.
    [[nodiscard]] double maxSpeed() const noexcept { return maxSpeed_; }
    /// Returns whether a path ended where the force was not held. Any thread; wait-free.
    [[nodiscard]] bool hasStopped() const noexcept { return stopped_; }

private:
    /// @param target of the device [m]
    void followAlong(const Vector3& target, double timeStep) noexcept;

    std::unique_ptr<HapticDevice> lateral_;
    ZFeedback feedback_;
    double stiffness_;  ///< as FeedbackPlan has it [N/m]
    Vector3 axis_;      ///< same
    double freeForce_;  ///< same [N]
    double positionGain_;
    Vector3 position_ = Vector3::Zero();  ///< of the device [m]
    double force_ = 0.0;            ///< of the tick before, along z as the bending shows it [N]
    double height_;                 ///< of the base in that tick [m]
    bool started_ = false;          ///< the first step only begins
    bool moves_ = false;            ///< along the sample
    std::atomic<double> setpoint_;  ///< [N]
    std::atomic<double> gain_ = kDefaultFeedbackGain;
    std::atomic<FeedbackState> state_ = FeedbackState::Holding;
    std::atomic<double> error_ = 0.0;     ///< [N]
    std::atomic<double> maxSpeed_ = 0.0;  ///< [m/s]
    std::atomic<bool> stopped_ = false;
};

}  // namespace asperity
