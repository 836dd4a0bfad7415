#include "ui/panels/ShownFlags.h"

#include <algorithm>
#include <limits>

namespace asperity {

namespace {

constexpr double kHold = 0.5;    ///< how long a flag stays shown [s of physics time]
constexpr double kWindow = 0.5;  ///< of the share of ticks, exponentially weighted [s]
constexpr double kMost = 0.5;    ///< share of ticks from which noise is no excuse
constexpr double kFew = 0.25;    ///< share below which it is one again
constexpr double kNever = -std::numeric_limits<double>::infinity();

}  // namespace

void ShownFlags::clear() noexcept {
    seen_.fill({.last = kNever});
    time_.reset();
}

void ShownFlags::take(const TickSample& sample) noexcept {
    const double step = std::clamp(sample.time - time_.value_or(sample.time), 0.0, kWindow);
    time_ = sample.time;
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        Seen& seen = seen_.at(i);
        const bool has = sample.output.flags.has(kValidityTraits.at(i).flag);
        if (has) {
            seen.last = sample.time;
        }
        seen.share += ((has ? 1.0 : 0.0) - seen.share) * step / kWindow;
        seen.inMost = seen.share > (seen.inMost ? kFew : kMost);
    }
}

bool ShownFlags::isShown(std::size_t index, const TickSample& latest) const {
    const ValidityTraits& flag = kValidityTraits.at(index);
    const Seen& seen = seen_.at(index);
    if (flag.basis == FlagBasis::Signals) {
        return seen.inMost;
    }
    const double age = latest.time - seen.last;
    // A notice of what is to come is void when it has come.
    const bool isOver =
        flag.severity == Severity::Notice ||
        (flag.basis == FlagBasis::Contact && latest.output.region() == TipRegion::Far);
    const bool lingers = !isOver && age >= 0.0 && age < kHold;
    return lingers || latest.output.flags.has(flag.flag);
}

}  // namespace asperity
