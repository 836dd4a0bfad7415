#pragma once

#include "core/probe/SimulatedAfm.h"

#include <limits>

namespace asperity::test {

/// An instrument that takes its time: it measures one thing after another, and each answer comes
/// `period` after the base was where it was measured. It can be lost.
class SlowAfm final : public AfmController {
public:
    SlowAfm(const SampleSurface& surface, const InstrumentTruth& truth, double period)
        : afm_(surface, truth), timeStep_(truth.timeStep), period_(period) {}

    AfmMeasurement exchange(const BaseMotion& target) noexcept override {
        elapsed_ += timeStep_;
        answer_.age += timeStep_;
        if (!begun_ || elapsed_ > period_ - 0.5 * timeStep_) {
            const AfmMeasurement measured = afm_.exchange(target);
            answer_ = begun_ ? underWay_ : measured;
            answer_.age = begun_ ? elapsed_ : 0.0;
            underWay_ = measured;
            elapsed_ = 0.0;
            begun_ = true;
        }
        constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
        return lost ? AfmMeasurement{.signals = {kNothing, kNothing},
                                     .age = kNothing,
                                     .connected = false}
                    : answer_;
    }

    bool lost = false;

private:
    SimulatedAfm afm_;
    double timeStep_;  ///< [s]
    double period_;    ///< [s]
    AfmMeasurement answer_;
    AfmMeasurement underWay_;
    double elapsed_ = 0.0;  ///< since what is under way was begun [s]
    bool begun_ = false;
};

}  // namespace asperity::test
