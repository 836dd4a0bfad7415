#include "app/reports/run/RunHistory.h"

#include <algorithm>
#include <optional>

namespace asperity {

void RunHistory::take(const TickSample& sample) {
    if (events().ticks == 0) {
        first_ = sample.time;
    }
    last_ = sample.time;
    events_.take(sample);
    path_.push_back(sample.output.tip);
    takeCurve(sample);
    takeFlags(sample.output);
}

void RunHistory::takeCurve(const TickSample& sample) {
    detector_.take(sample.time, sample.input, sample.output);
    if (detector_.number() != number_) {
        number_ = detector_.number();
        present_.clear();
    }
    present_.take(detector_);
    const std::size_t touches = events().cycles.size();
    if (!detector_.cycle().touched() || touches > kDrawnTouches) {
        return;
    }
    if (curves_.size() < touches) {
        curves_.emplace_back();
    }
    curves_.back() = {detector_.cycle(), present_};
}

void RunHistory::takeFlags(const TickOutput& out) {
    std::optional<Severity> worst;
    for (const ValidityTraits& traits : kValidityTraits) {
        if (traits.basis != FlagBasis::Signals && out.flags.has(traits.flag)) {
            worst = std::max(worst.value_or(traits.severity), traits.severity);
        }
    }
    if (worst) {
        ++worst_.at(static_cast<std::size_t>(*worst));
    }
    if (out.fault != Fault::None) {
        ++faults_[out.fault];
    }
}

}  // namespace asperity
