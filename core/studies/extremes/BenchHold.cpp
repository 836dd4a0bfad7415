#include "core/studies/extremes/BenchHold.h"

#include "core/haptics/HapticTick.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr double kStart = 4e-3;     // height of the device [m]
constexpr double kTapTime = 10e-3;  // from one goal to the next [s]
constexpr double kPressed = -3e-3;
constexpr double kPressedHard = -8e-3;
constexpr std::array kGoals{kPressed, 0.5e-3, kPressedHard};  // heights of the device [m]

ArmImpedance armOf(Grip grip) {
    return grip == Grip::Normal ? kNormalGrip : kLightGrip;  // before a device opens it is light
}

/// Amplitude of the handle's oscillation along any axis: the lesser of its largest rise and its
/// largest fall. A handle that creeps one way does not swing.
class Swing {
public:
    void add(const Vector3& point) {
        low_ = low_.cwiseMin(point);
        high_ = high_.cwiseMax(point);
        rise_ = rise_.cwiseMax(point - low_);
        fall_ = fall_.cwiseMax(high_ - point);
    }
    [[nodiscard]] double size() const { return rise_.cwiseMin(fall_).maxCoeff(); }

private:
    Vector3 low_ = Vector3::Constant(HUGE_VAL);
    Vector3 high_ = Vector3::Constant(-HUGE_VAL);
    Vector3 rise_ = Vector3::Zero();
    Vector3 fall_ = Vector3::Zero();
};

/// A device, the bench, the tick and the instrument.
class HeldTip {
public:
    HeldTip(const Scene& scene, const BenchHold& hold, const CancelCheck& check)
        : scene_(scene)
        , check_(check)
        , bench_({.arm = armOf(hold.grip), .delay = hold.delay},
                 above(kStart, hold.scale.positionGain))
        , afm_(scene.trueSurface(), truthOf(scene)) {
        input_.settings = scene.settings;
        input_.settings.positionGain = hold.scale.positionGain;
        input_.settings.forceGain = hold.scale.forceGain;
        input_.settings.coupling = hold.coupling;
        input_.timeStep = scene.timeStep();
    }

    /// Goes there and waits until the handle rests.
    /// @return its swing in the last window [m]
    double goTo(double height) {
        const double from = goal_;
        for (double time = 0.0; time < kTapTime; time += input_.timeStep) {
            step(from + (height - from) * std::min(1.0, time / kTapTime));
        }
        goal_ = height;
        return settle();
    }

    /// Lets go of the handle, then as goTo().
    double letGo() {
        bench_.grip(kNoGrip);
        return settle();
    }

    [[nodiscard]] bool finite() const { return finite_; }

private:
    [[nodiscard]] Vector3 above(double height, double positionGain) const {
        return {0.5 * scene_.surface.sizeX() / positionGain,
                0.5 * scene_.surface.sizeY() / positionGain, height};
    }

    double settle() {
        double swing = HUGE_VAL;
        for (double time = 0.0; time < kPatience && swing >= kStillWithin && finite_;
             time += kRestWindow) {
            swing = swingInWindow();
        }
        return swing;
    }

    double swingInWindow() {
        check_();
        Swing swing;
        for (double time = 0.0; time < kRestWindow; time += input_.timeStep) {
            step(goal_);
            swing.add(bench_.position());
        }
        return swing.size();
    }

    void step(double height) {
        bench_.reachFor(above(height, input_.settings.positionGain));
        input_.device = bench_.advance(input_.timeStep);
        const BaseCommand command = commandBase(scene_, input_, memory_, tracker_);
        input_.measurement = afm_.exchange(command.base);
        const TickOutput output = tick(scene_, input_, command, memory_, tracker_);
        bench_.setForce(output.deviceForce);
        finite_ = finite_ && output.fault == Fault::None;
    }

    const Scene& scene_;
    const CancelCheck& check_;
    VirtualBench bench_;
    SimulatedAfm afm_;
    TickInput input_;
    TickMemory memory_;
    ClosestPointTracker tracker_;
    double goal_ = kStart;  ///< height [m]
    bool finite_ = true;
};

}  // namespace

std::optional<double> swingOnBench(const Scene& scene, const BenchHold& hold,
                                   const CancelCheck& check) {
    HeldTip tip(scene, hold, check);
    double swing = 0.0;
    if (hold.grip == Grip::None) {
        tip.goTo(kPressedHard);
        swing = tip.letGo();
    } else {
        for (const double goal : kGoals) {
            swing = std::max(swing, tip.goTo(goal));
            if (swing >= kStillWithin) {
                break;
            }
        }
    }
    return tip.finite() ? std::optional(swing) : std::nullopt;
}

}  // namespace asperity
