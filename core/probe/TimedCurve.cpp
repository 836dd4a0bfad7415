#include "core/probe/TimedCurve.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kStepsPerPoint = 8;

/// A tip on a lever whose base goes from place to place.
class MovingTip {
public:
    MovingTip(const ContactModel& model, const TimeTerms& terms, double compliance,
              const TimedCurvePlan& plan)
        : model_(model)
        , terms_(terms)
        , compliance_(compliance)
        , speed_(plan.speed)
        , setpoint_(plan.setpoint)
        , base_(plan.way.farthest) {
        state_ = stepped(TimedContact(terms_, time_, 0.0), base_);
    }

    [[nodiscard]] ForceCurvePoint point() const { return {base_, state_}; }
    [[nodiscard]] bool isAtSetpoint() const { return setpoint_ && state_.force >= *setpoint_; }

    /// Follows the base to a place, or on the way in to the setpoint; the jump on the way there.
    std::optional<TipJump> go(double target) {
        std::optional<TipJump> jump;
        const double step = (target - base_) / kStepsPerPoint;
        for (int i = 0; i < kStepsPerPoint && !(step > 0.0 && isAtSetpoint()); ++i) {
            const ContactState before = state_;
            base_ += step;
            state_ = stepped(TimedContact(terms_, time_, std::abs(step) / speed_), base_);
            if (state_.jumped) {
                jump = {base_, before, state_};
            }
        }
        return jump;
    }

private:
    ContactState stepped(const TimedContact& step, double base) {
        ContactPair pair = model_.pair();
        pair.reducedModulus *= step.stiffening();
        const ContactModel stepModel = model_.withPair(pair);
        // The drag counts for the gap that it leaves.
        constexpr int kSweeps = 4;
        ContactState state = state_;
        for (int i = 0; i < kSweeps; ++i) {
            state = step.equilibrium(stepModel, base, compliance_, memory_, state.indentation);
        }
        time_ = step.after(stepModel, state);
        memory_ = state.memory();
        return state;
    }

    const ContactModel& model_;
    TimeTerms terms_;
    double compliance_;
    double speed_;
    std::optional<double> setpoint_;
    double base_;
    ContactState state_;
    ContactMemory memory_;
    TimeMemory time_;
};

}  // namespace

ForceCurve timedCurve(const ContactModel& model, const TimeTerms& terms, double compliance,
                      const TimedCurvePlan& plan) {
    MovingTip tip(model, terms, compliance, plan);
    ForceCurve curve;
    const double step = (plan.way.deepest - plan.way.farthest) / (plan.way.points - 1);
    const auto follow = [&](double direction, std::vector<ForceCurvePoint>& points, int count,
                            std::optional<TipJump>& found) {
        for (int i = 1; i < count && !(direction > 0.0 && tip.isAtSetpoint()); ++i) {
            if (const auto jump = tip.go(tip.point().basePosition + (direction * step))) {
                found = jump;
            }
            points.push_back(tip.point());
        }
    };
    curve.approach.push_back(tip.point());
    follow(1.0, curve.approach, plan.way.points, curve.snapIn);
    curve.retract.push_back(tip.point());
    follow(-1.0, curve.retract, static_cast<int>(curve.approach.size()), curve.pullOff);
    const auto strongest = std::ranges::min_element(
        curve.retract, {}, [](const ForceCurvePoint& point) { return point.state.force; });
    if (strongest->state.force < 0.0) {
        curve.strongest = *strongest;
    }
    return curve;
}

}  // namespace asperity
