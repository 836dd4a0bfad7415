#include "core/probe/TimedContact.h"

#include <algorithm>
#include <cmath>

namespace asperity {

TimedContact::TimedContact(const TimeTerms& terms, const TimeMemory& memory,
                           double elapsed) noexcept
    : terms_(terms), memory_(memory), elapsed_(elapsed) {
    const double times = elapsed / terms.relaxationTime;
    decay_ = std::exp(-times);
    mean_ = times > 0.0 ? -std::expm1(-times) / times : 1.0;
}

/// How much less than the law of the step has the sample presses, since it has relaxed [N].
double TimedContact::relaxedForce(const ContactModel& model) const noexcept {
    const double longModulus = model.pair().reducedModulus / stiffening();
    return terms_.relaxingShare * longModulus *
           ((memory_.load * mean_) - (memory_.relaxing * decay_));
}

ContactState TimedContact::equilibrium(const ContactModel& model, double approach,
                                       double compliance, const ContactMemory& memory,
                                       double guess) const noexcept {
    if (!terms_.any()) {
        return model.equilibrium(approach, compliance, memory);
    }
    const double gap = std::max(-guess, 0.0);
    const double perWay =
        memory_.known ? terms_.drag / (elapsed_ * (gap + terms_.dragOffset)) : 0.0;
    const BodyPull drag{.force = -perWay * memory_.indentation, .slope = perWay};
    const BodyPull& beside = model.bodyPull();
    ContactModel timed = model;
    timed.setBodyPull({.force = beside.force + drag.force - relaxedForce(model),
                       .slope = beside.slope + drag.slope});
    ContactState state = timed.equilibrium(approach, compliance, memory);
    state.drag = drag.at(state.indentation);
    if (terms_.relaxes() && state.force < state.drag) {
        // The surface has not followed the tip.
        state = {.indentation = drag.bareApproach(approach, compliance)};
        state.drag = drag.at(state.indentation);
        state.force = state.drag;
        state.stiffness = perWay;
    }
    return state;
}

TimeMemory TimedContact::after(const ContactModel& model,
                               const ContactState& state) const noexcept {
    if (!terms_.any()) {
        return {};
    }
    TimeMemory now{.known = true, .indentation = state.indentation};
    if (terms_.relaxes()) {
        // Without contact this is the load that would hold the surface where it is by now.
        now.load = (state.force - state.drag + relaxedForce(model)) / model.pair().reducedModulus;
        now.relaxing = (memory_.relaxing * decay_) + ((now.load - memory_.load) * mean_);
    }
    return now;
}

}  // namespace asperity
