#include "core/scene/TickOutput.h"

namespace asperity {

const char* faultName(Fault fault) noexcept {
    switch (fault) {
    case Fault::None:
        return "none";
    case Fault::NotFinite:
        return "not_finite";
    case Fault::DeviceLost:
        return "device_lost";
    case Fault::DeviceSilent:
        return "device_silent";
    case Fault::VelocityTrip:
        return "velocity_trip";
    case Fault::SolverFailed:
        return "solver_failed";
    case Fault::InstrumentLost:
        return "instrument_lost";
    }
    return "unknown";
}

}  // namespace asperity
