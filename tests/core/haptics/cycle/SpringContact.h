#pragma once

#include "core/Random.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/cycle/CycleDetector.h"

#include <cmath>
#include <functional>

namespace asperity::test {

/// A tip on a lever over a spring that holds on to it up to a certain pull: a cycle of which all is
/// known. One call a tick; the model is right unless told otherwise.
class SpringContact {
public:
    static constexpr double kLever = 14.0;    ///< [N/m]
    static constexpr double kContact = 50.0;  ///< [N/m]
    static constexpr double kPull = 5e-9;     ///< at which it comes off [N]
    static constexpr double kTogether = kLever * kContact / (kLever + kContact);
    static constexpr double kWork = 0.5 * kPull * kPull / kTogether;  ///< of adhesion [J]
    static constexpr double kSigma = 0.1e-9;                          ///< of an estimate [N]
    static constexpr double kStep = 2e-12;  ///< of the base a tick, but for `step` [m]

    /// @param noise of the estimate [N]
    explicit SpringContact(double noise = 0.0) : noise_(noise) {}

    /// Moves the base to this distance from first touch [m].
    void moveTo(double distance) {
        while (std::abs(distance - base_) > 0.5 * step) {
            base_ += std::copysign(step, distance - base_);
            tick();
        }
    }
    void rest(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            tick();
        }
    }
    void oneCycle() {
        moveTo(-2e-9);
        moveTo(4e-9);
    }

    CycleDetector detector;
    TickSample sample;                     ///< the latest tick
    std::function<void()> onTick = [] {};  ///< after each
    double attraction = 0.0;               ///< of the free tip within 1 nm [N]
    long modelLag = 0;  ///< ticks by which the model comes off later; < 0: before any pull
    bool solved = true;
    double step = kStep;        ///< of the base a tick [m]
    double contact = kContact;  ///< stiffness of the sample [N/m]
    int touches = 0;            ///< cycles that came into contact

    [[nodiscard]] const ContactCycle& cycle() const { return detector.cycle(); }

private:
    void tick() {
        const double force = trueForce();
        TickOutput& out = sample.output;
        out.base.position.z() = base_;
        out.model.tip.z() = base_ + force / kLever;
        out.model.contact.indentation = -out.model.tip.z();
        out.model.contact.branch = modelBonded(force) ? ContactBranch::Bonded : ContactBranch::Far;
        out.model.contact.stiffness = bonded_ ? contact : 0.0;
        out.model.contact.status =
            solved ? ContactStatus::Solved : ContactStatus::ApproachOutOfRange;
        out.estimate.force.z() = force + noise_ * random_.normal();
        out.estimate.covariance = kSigma * kSigma * Matrix3::Identity();
        out.tip.z() = base_ + out.estimate.force.z() / kLever;
        const bool before = cycle().phase == CyclePhase::Contact;
        sample.time += 1e-3;
        detector.take(sample.time, sample.input, out);
        touches += !before && cycle().phase == CyclePhase::Contact ? 1 : 0;
        onTick();
    }

    double trueForce() {
        const double force = -kLever * contact / (kLever + contact) * base_;
        bonded_ = bonded_ ? force >= -kPull : base_ <= 0.0;
        if (bonded_) {
            return force;
        }
        return base_ < 1e-9 ? -attraction : 0.0;
    }

    bool modelBonded(double force) {
        ticksFree_ = bonded_ ? 0 : ticksFree_ + 1;
        if (modelLag < 0) {
            return bonded_ && force >= 0.0;
        }
        return bonded_ || (touches > 0 && ticksFree_ <= modelLag);
    }

    Random random_{1};
    double noise_;
    double base_ = 4e-9;
    bool bonded_ = false;
    long ticksFree_ = 0;
};

}  // namespace asperity::test
