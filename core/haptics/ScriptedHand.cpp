#include "core/haptics/ScriptedHand.h"

#include <utility>

namespace asperity {

ScriptedHand::ScriptedHand(HandPath path, double positionGain)
    : path_(std::move(path)), positionGain_(positionGain) {}

HandState ScriptedHand::advance(double timeStep) noexcept {
    if (started_) {
        time_ += timeStep;
    }
    started_ = true;
    return {.position = positionAt(path_, time_) / positionGain_};
}

}  // namespace asperity
