#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/haptics/coupling/PassivityObserver.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// The passivity observer over the ticks of a run, while a force-feedback device drives the tip by
/// a coupling. It begins again with another coupling and each time the loop starts.
class EnergyWatch {
public:
    /// @param timeStep from tick to tick [s]
    /// @param delay    of the device [s]
    EnergyWatch(double timeStep, double delay) : timeStep_(timeStep), delay_(delay) {}

    /// Every tick, in order.
    void take(const TickSample& sample);

    /// As of the last tick; null: no such device drives the tip.
    [[nodiscard]] const PassivityObserver* observer() const noexcept {
        return observer_ ? &*observer_ : nullptr;
    }
    /// Returns whether the device gets energy from no known source: the operator must be warned.
    [[nodiscard]] bool active() const noexcept { return observer_ && observer_->active(); }

private:
    double timeStep_;  ///< [s]
    double delay_;     ///< [s]
    std::optional<PassivityObserver> observer_;
    CouplingGains gains_;       ///< that it was made for
    std::uint32_t starts_ = 0;  ///< same
};

}  // namespace asperity
