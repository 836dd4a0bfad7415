#include "core/scene/ForceModelOptions.h"

#include "core/scene/ModelTerm.h"

namespace asperity {

ForceModelOptions ofForce(ForceModelOptions options) noexcept {
    options.deformation = ForceModelOptions{}.deformation;
    options.curvature = options.curvature || isSphere(options.law);
    options.bodyAttraction = options.bodyAttraction && hasTail(options.law);
    options.retractWork = options.retractWork && isJkr(options.law);
    options.relaxation = options.relaxation && !isAdhesive(options.law);
    return options;
}

}  // namespace asperity
