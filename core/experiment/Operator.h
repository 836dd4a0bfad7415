#pragma once

#include "core/Random.h"
#include "core/Vector.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/device/HapticDevice.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// A person as the operator model has it; lengths are those of the hand and of the screen. Where
/// the numbers come from: docs/experiments.md.
struct OperatorTraits {
    double sightTime = 0.25;    ///< from what the screen shows to a movement that answers it [s]
    double touchTime = 0.15;    ///< same from what the hand feels [s]
    double moveTime = 0.05;     ///< of a movement of no difficulty, Fitts' a [s]
    double timePerBit = 0.12;   ///< Fitts' b [s/bit]
    double aimError = 0.05;     ///< standard deviation of a movement's end, of its length
    double acuity = 0.3e-3;     ///< standard deviation of a position seen on the screen [m]
    double depthFactor = 3.0;   ///< by how much that is more along the line of sight
    double hiddenFactor = 3.0;  ///< by how much that is more of a tip that nothing shows
    double leastForce = 0.06;   ///< change of force that the hand notices [N]
    double forceShare = 0.1;    ///< same as a share of the force (Weber)
    double tremor = 0.05e-3;    ///< root mean square, each axis [m]
    double tremorRate = 9.0;    ///< [Hz]
    double tolerance = 1.0e-3;  ///< distance on the screen with which the person is content [m]
    double patience = 10.0;     ///< in which the person becomes content with twice as much [s]
    double dwell = 0.3;         ///< for which the tip is looked at before the button is pressed [s]
    double pressTime = 0.2;     ///< from the decision to the button [s]
    ArmImpedance arm = kNormalGrip;
};

/// Somebody: each trait that differs from person to person is drawn around the usual one, with a
/// standard deviation of 20 % (log-normal).
[[nodiscard]] OperatorTraits drawOperator(Random& random);
/// A participant of a study with this seed, from 1.
[[nodiscard]] OperatorTraits operatorOf(std::uint64_t seed, int participant);

/// View of a moment in the window: pictures, numbers, not the truth.
struct ShownMoment {
    Vector3 tip = Vector3::Zero();  ///< apex, as the window shows it, world [m]
    bool hidden = false;            ///< it is below the surface that is drawn
};

/// The picture as an operator sees it: frame by frame, late, and not exactly.
class OperatorSight {
public:
    /// @param scale meters on the screen per meter of the sample
    /// @param lineOfSight unit
    OperatorSight(const OperatorTraits& person, double scale, const Vector3& lineOfSight);

    /// One more tick of the loop. @param timeStep since the last one [s]
    void show(const ShownMoment& moment, double timeStep);
    /// Returns whether there is anything to be seen yet.
    [[nodiscard]] bool isOpen() const noexcept { return !frames_.empty(); }
    /// Returns where the operator, at a new look, takes the tip to be [m].
    [[nodiscard]] Vector3 look(Random& random) const;

private:
    [[nodiscard]] const ShownMoment& seen() const;

    OperatorTraits person_;
    double scale_;
    Vector3 lineOfSight_;
    std::size_t length_;               ///< of the ring: frames by which sight is late
    std::vector<ShownMoment> frames_;  ///< a ring
    std::size_t newest_ = 0;
    double sinceFrame_ = 0.0;  ///< [s]
};

/// The force as a hand feels it: a change is noticed where it is large enough beside what acts
/// already, and answered late.
class OperatorTouch {
public:
    explicit OperatorTouch(const OperatorTraits& person) : person_(person) {}

    void feel(const Vector3& force, double timeStep);
    /// Returns once whether a change of the force was noticed that can be answered now.
    [[nodiscard]] bool takeNotice();

private:
    OperatorTraits person_;
    Vector3 usual_ = Vector3::Zero();  ///< what the hand is used to [N]
    double since_ = -1.0;              ///< the change that is not answered yet; < 0: there is none
    bool noticed_ = false;
};

/// Task of an operator, and the view of it in the window.
struct OperatorTask {
    Vector3 target = Vector3::Zero();  ///< of the tip's apex, world [m]
    double positionGain = 1e-6;        ///< of the device
    double screenScale = 1e7;          ///< meters on the screen per meter of the sample
    Vector3 lineOfSight = Vector3(0.0, 0.8, -0.6);  ///< unit, world
};

/// A person at the device, who knows no more than the window shows and the hand feels: movements of
/// minimum jerk toward where the target is seen, each with an error that grows with its length, a
/// look after each, until the tip is seen near enough for long enough; then the button. A force
/// that is suddenly felt stops the movement. No allocation after construction. Source: Flash, Hogan
/// (1985); Fitts (1954); docs/experiments.md.
class Operator {
public:
    /// @param hand where it rests at first, in the device's frame [m]
    Operator(const OperatorTraits& person, const OperatorTask& task, const Vector3& hand,
             std::uint64_t seed);

    /// The trial begins: until then the hand rests.
    void begin();
    /// One more tick [s]. @return where the hand is drawn to, in the device's frame [m]
    Vector3 advance(double timeStep);
    void see(const ShownMoment& moment, double timeStep) { sight_.show(moment, timeStep); }
    void feel(const Vector3& force, double timeStep) { touch_.feel(force, timeStep); }

    [[nodiscard]] bool hasPressed() const noexcept { return phase_ == Phase::Pressed; }
    [[nodiscard]] int movements() const noexcept { return movements_; }

private:
    enum class Phase : std::uint8_t { Resting, Looking, Moving, Checking, Pressing, Pressed };

    void enter(Phase phase);
    void decide();
    void check();
    void move(const Vector3& way);
    [[nodiscard]] Vector3 missing();
    [[nodiscard]] double tolerance() const;
    [[nodiscard]] double timeFor(double length) const;
    [[nodiscard]] Vector3 trembled(double timeStep);

    OperatorTraits person_;
    OperatorTask task_;
    Random random_;
    OperatorSight sight_;
    OperatorTouch touch_;
    Phase phase_ = Phase::Resting;
    double inPhase_ = 0.0;     ///< [s]
    double sinceBegin_ = 0.0;  ///< [s]
    double sinceLook_ = 0.0;   ///< while checking [s]
    Vector3 hand_;             ///< where it is meant to be [m]
    Vector3 from_;             ///< of the movement [m]
    Vector3 to_;               ///< of the movement [m]
    double duration_ = 0.0;    ///< of the movement [s]
    int movements_ = 0;
    Vector3 tremble_ = Vector3::Zero();       ///< [m]
    Vector3 trembleSpeed_ = Vector3::Zero();  ///< [m/s]
};

/// The virtual bench in an operator's hand: a haptic device that moves by itself.
class OperatedBench final : public HapticDevice {
public:
    /// @param start where handle and hand rest at first, in the device's frame [m]
    OperatedBench(const BenchSetup& setup, const Vector3& start, const Operator& person)
        : bench_(setup, start), operator_(person) {}

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return bench_.specification();
    }
    [[nodiscard]] double delay() const noexcept override { return bench_.delay(); }
    DeviceState advance(double timeStep) noexcept override;
    void setForce(const Vector3& force) noexcept override;
    void observe(const TickOutput& output) noexcept override;

    [[nodiscard]] Operator& person() noexcept { return operator_; }
    /// Returns the true position of the handle [m].
    [[nodiscard]] const Vector3& position() const noexcept { return bench_.position(); }
    /// Sets whether the deformed surface is drawn; without it a tip in the sample is hidden.
    void showDeformation(bool shown) noexcept { deformationShown_ = shown; }

private:
    VirtualBench bench_;
    Operator operator_;
    Vector3 force_ = Vector3::Zero();  ///< that acts at the handle [N]
    double timeStep_ = 1e-3;           ///< [s]
    bool deformationShown_ = true;
};

}  // namespace asperity
