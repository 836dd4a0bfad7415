#pragma once

#include "core/SiFormat.h"
#include "core/haptics/VirtualRun.h"

#include <string>

namespace asperity {

/// Writes time, normal force, distance and state of moments in one line. Moments that are taken
/// first decide on the units, so that digits stay where they are from one line to the next.
class MomentCaption {
public:
    void take(const TickSample& sample);
    /// "t = 3.214 s, normal force 12.30 nN, indentation 1.20 nm, in contact"; the force is the
    /// estimate, along the normal of the surface.
    [[nodiscard]] std::string of(const TickSample& sample) const;

private:
    double force_ = 0.0;     ///< largest magnitude so far [N]
    double distance_ = 0.0;  ///< [m]
};

}  // namespace asperity
