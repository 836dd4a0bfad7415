#pragma once

#include "core/experiment/Perception.h"
#include "core/haptics/bench/VirtualBench.h"

#include <cstdint>

namespace asperity {

/// What an operator has to do, and how the window shows it.
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

}  // namespace asperity
