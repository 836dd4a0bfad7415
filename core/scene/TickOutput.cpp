#include "core/scene/TickOutput.h"

namespace asperity {

TipRegion TickOutput::region() const noexcept {
    if (model.contact.branch == ContactBranch::Far) {
        return TipRegion::Far;
    }
    return model.contact.contactRadius > 0.0 ? TipRegion::Contact : TipRegion::Cohesive;
}

const char* regionName(TipRegion region) noexcept {
    switch (region) {
    case TipRegion::Far:
        return "far";
    case TipRegion::Cohesive:
        return "cohesive";
    case TipRegion::Contact:
        return "contact";
    }
    return "unknown";
}

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
