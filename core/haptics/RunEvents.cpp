#include "core/haptics/RunEvents.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kAgreementSigmas = 3.0;
constexpr double kAgreementShare = 0.2;  // of the model's force

/// Normal force of one tick, as the signals and as the model have it, along the model's normal.
struct NormalForces {
    double estimate = 0.0;  ///< [N]
    double sigma = 0.0;     ///< of the estimate [N]
    double model = 0.0;     ///< [N]

    explicit NormalForces(const TickOutput& out)
        : estimate(out.estimate.force.dot(out.model.normal))
        , sigma(std::sqrt(out.model.normal.dot(out.estimate.covariance * out.model.normal)))
        , model(out.model.normalForce) {}

    [[nodiscard]] double weakerPull() const { return -std::max(estimate, model); }
    [[nodiscard]] bool agree() const {
        return std::abs(estimate - model) <=
               std::max(kAgreementSigmas * sigma, kAgreementShare * std::abs(model));
    }
};

}  // namespace

void HoldRecorder::take(const TickSample& sample) {
    const NormalForces forces(sample.output);
    if (!(forces.weakerPull() > 0.0)) {
        return;
    }
    if (forces.agree()) {
        agreeing_ = sample;
    } else if (!strongest_ || forces.weakerPull() > NormalForces(strongest_->output).weakerPull()) {
        strongest_ = sample;
    }
}

std::optional<TickSample> HoldRecorder::release() {
    std::optional<TickSample> last = agreeing_ ? agreeing_ : strongest_;
    agreeing_.reset();
    strongest_.reset();
    return last;
}

void RunEventRecorder::take(const TickSample& sample) {
    ++events_.ticks;
    takeJumps(sample);
    takeExtremes(sample);
    takeCycle(sample);
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        if (sample.output.flags.has(kValidityTraits.at(i).flag)) {
            ++events_.flagged.at(i);
        }
    }
    if (sample.output.fault != Fault::None) {
        ++events_.faults;
    }
    previous_ = sample;
}

void RunEventRecorder::takeJumps(const TickSample& sample) {
    const ContactBranch now = sample.output.model.contact.branch;
    if (now == ContactBranch::Bonded) {
        holds_.take(sample);
    }
    if (!previous_) {
        events_.bondedFromStart = now == ContactBranch::Bonded;
        return;
    }
    const ContactBranch before = previous_->output.model.contact.branch;
    if (before == now) {
        return;
    }
    if (now == ContactBranch::Bonded && !events_.snapIn) {
        events_.beforeSnapIn = previous_;
        events_.snapIn = sample;
    }
    if (now == ContactBranch::Far) {
        events_.beforePullOff = previous_;
        events_.pullOff = sample;
        events_.lastHold = holds_.release();
    }
}

void RunEventRecorder::takeExtremes(const TickSample& sample) {
    const ContactState& contact = sample.output.model.contact;
    if (!events_.deepest ||
        contact.indentation > events_.deepest->output.model.contact.indentation) {
        events_.deepest = sample;
    }
    if (!events_.strongestPull ||
        contact.force < events_.strongestPull->output.model.contact.force) {
        events_.strongestPull = sample;
    }
    events_.largestForce = std::max(events_.largestForce, sample.output.model.force.norm());
    events_.largestEstimatedForce =
        std::max(events_.largestEstimatedForce, sample.output.estimate.force.norm());
}

void RunEventRecorder::takeCycle(const TickSample& sample) {
    cycles_.take(sample.time, sample.input, sample.output);
    if (!cycles_.cycle().touched()) {
        return;
    }
    if (lastCycle_ != cycles_.number()) {
        lastCycle_ = cycles_.number();
        events_.cycles.emplace_back();
    }
    events_.cycles.back() = cycles_.cycle();
}

}  // namespace asperity
