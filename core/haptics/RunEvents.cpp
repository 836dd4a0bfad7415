#include "core/haptics/RunEvents.h"

#include <algorithm>

namespace asperity {

void RunEventRecorder::take(const TickSample& sample) {
    ++events_.ticks;
    takeJumps(sample);
    takeExtremes(sample);
    for (unsigned i = 0; i < kValidityFlagCount; ++i) {
        if (sample.output.flags.has(static_cast<Validity>(1U << i))) {
            ++events_.flagged.at(i);
        }
    }
    if (sample.output.fault != Fault::None) {
        ++events_.faults;
    }
    previous_ = sample;
}

void RunEventRecorder::takeJumps(const TickSample& sample) {
    if (!previous_) {
        return;
    }
    const ContactBranch before = previous_->output.model.contact.branch;
    const ContactBranch now = sample.output.model.contact.branch;
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

}  // namespace asperity
