#pragma once

#include "core/probe/DetectorCalibration.h"
#include "core/probe/TipEquilibrium.h"

namespace asperity {

/// Latest measurement of the instrument.
struct AfmMeasurement {
    LeverSignals signals;
    double age = 0.0;       ///< since it was measured [s]
    bool connected = true;  ///< false: the instrument is lost, the signals mean nothing
};

/// The instrument as the rest of the program sees it: takes the newest target of the base and gives
/// the newest measurement with its age. Implementations never wait and never throw.
class AfmController {
public:
    virtual ~AfmController() = default;
    virtual AfmMeasurement exchange(const BaseMotion& target) noexcept = 0;
};

}  // namespace asperity
