#include "core/haptics/EnergyWatch.h"

namespace asperity {

void EnergyWatch::take(const TickSample& sample) {
    const CouplingGains& gains = sample.input.settings.coupling;
    if (!sample.input.device.rendersForce() || !gains.couples()) {
        observer_.reset();
        return;
    }
    if (!observer_ || gains != gains_ || sample.input.starts != starts_) {
        observer_.emplace(gains.stiffness, timeStep_, delay_);
        gains_ = gains;
        starts_ = sample.input.starts;
    }
    observer_->observe(sample.input.device.position, sample.output.deviceForce);
}

}  // namespace asperity
