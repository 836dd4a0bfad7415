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
    }
    return "unknown";
}

}  // namespace asperity
