#include "core/haptics/coupling/CoupledDevice.h"

#include "core/Error.h"

#include <algorithm>

namespace asperity {

namespace {

CoupledDevice judged(const ProbeSystem& tip, const DeviceRequest& request,
                     const CouplingGains& gains) {
    const double force = std::min(request.device.maxForce, request.maxForce);
    const TipLoad load = tipLoad(tip, force / request.scale.forceGain, request.control);
    return {.gains = gains,
            .judgment = judgeScale(load, request.scale, gains,
                                   {.stiffness = request.device.maxStiffness,
                                    .force = force,
                                    .timeStep = request.timing.timeStep},
                                   request.guide),
            .noCoupling = {}};
}

}  // namespace

CoupledDevice coupleDevice(const ProbeSystem& tip, const DeviceRequest& request) {
    try {
        if (request.own.couples() && holdsHandle(request.own, request.device, request.timing)) {
            if (CoupledDevice own = judged(tip, request, request.own); own.holds()) {
                return own;
            }
        }
        return judged(tip, request, designCoupling(request.device, request.timing));
    } catch (const Error& error) {
        return {.gains = {}, .judgment = {}, .noCoupling = error.what()};
    }
}

}  // namespace asperity
