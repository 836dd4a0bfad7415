#pragma once

#include "core/Vector.h"
#include "core/haptics/VirtualRun.h"

namespace asperity {

/// The force as people read it: the mean of a tenth of a second, so that arrow and numbers stand
/// still while the tip does. A jump into contact or out of it begins another mean.
class SteadyForce {
public:
    static constexpr double kPeriod = 0.1;  ///< time constant of the mean [s]

    /// Sets the time constant of the mean [s].
    void setPeriod(double period) noexcept { period_ = period; }
    /// Takes the next tick.
    void take(const TickSample& sample) noexcept;
    /// Gives a tick the mean up to it. Of a single tick it is the tick's own.
    void apply(TickOutput& output) const noexcept;

private:
    Vector3 force_ = Vector3::Zero();       ///< [N]
    Matrix3 covariance_ = Matrix3::Zero();  ///< mean of the ticks': that of one of them [N^2]
    TipRegion region_ = TipRegion::Far;
    double time_ = 0.0;        ///< of the last tick [s]
    double span_ = 0.0;        ///< that the mean covers, at most period_ [s]
    double period_ = kPeriod;  ///< [s]
    bool isEmpty_ = true;
};

}  // namespace asperity
