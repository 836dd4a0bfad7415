#pragma once

#include "ui/Steady.h"

namespace asperity {

/// How long forces are drawn: such that the largest of the last moments fills its room, in round
/// steps that seldom change. A force that is only noise never draws a long arrow.
class ForceScale {
public:
    /// @param magnitude of the force [N]
    /// @param sigma     its standard deviation [N]
    /// @param time      of the run [s]
    /// @param room      length that the largest force may have [m]
    /// @return          length per force [m/N]
    double fit(double magnitude, double sigma, double time, double room);

private:
    SteadyFactor factor_{1e-15};
    double peak_ = 0.0;  ///< [N]
    double time_ = 0.0;  ///< of the last call [s]
};

}  // namespace asperity
