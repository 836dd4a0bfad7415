#include "core/scene/LawRangeTally.h"

#include "core/scene/LawRange.h"
#include "core/scene/Scene.h"
#include "core/scene/TickOutput.h"

#include <algorithm>

namespace asperity {

void LawRangeTally::take(const Scene& scene, const TickOutput& output) noexcept {
    if (!output.flags.has(Validity::LawOutOfRange)) {
        return;
    }
    const TipState& state = output.model;
    const LawError error = lawError(contactModelAt(scene, state), state.contact);
    ++ticks_;
    anySign_ += error.isSignSure ? 0 : 1;
    largest_ = std::max(largest_, error.force);
}

}  // namespace asperity
