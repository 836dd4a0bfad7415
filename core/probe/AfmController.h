#pragma once

#include "core/probe/DetectorCalibration.h"
#include "core/probe/TipEquilibrium.h"

namespace asperity {

/// Latest measurement of the instrument.
struct AfmMeasurement {
    LeverSignals signals;
    double age = 0.0;       ///< since it was measured [s]
    bool connected = true;  ///< false: the instrument is lost, the signals mean nothing
    // Of an instrument that plays a recorded curve; one that measures has none of them.
    bool extrapolated = false;  ///< the record has no such motion
    bool aside = false;         ///< the base is beside the place of the record
    bool ended = false;         ///< the base is deeper than the record: not connected
};

/// The instrument as the rest of the program sees it: takes the newest target of the base and gives
/// the newest measurement with its age. Implementations never wait and never throw.
class AfmController {
public:
    virtual ~AfmController() = default;
    virtual AfmMeasurement exchange(const BaseMotion& target) noexcept = 0;
};

}  // namespace asperity
