#include "core/contact/ContactState.h"

namespace asperity {

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

}  // namespace asperity
