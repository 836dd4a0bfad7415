#pragma once

#include "core/probe/Cantilever.h"
#include "core/probe/DetectorCalibration.h"

namespace asperity {

/// All that a probe file says: the lever and how its slopes are read.
struct ProbeDescription {
    CantileverGeometry lever;
    DetectorCalibration detector;

    bool operator==(const ProbeDescription&) const = default;
};

}  // namespace asperity
