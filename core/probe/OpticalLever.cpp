#include "core/probe/OpticalLever.h"

namespace asperity {

LeverSignals leverSignals(const Cantilever& cantilever, const Vector3& force) noexcept {
    const Vector3 local = cantilever.rotation() * force;
    return {.bending =
                (cantilever.bendingPerFz() * local.z()) + (cantilever.bendingPerFx() * local.x()),
            .torsion = cantilever.torsionPerFy() * local.y()};
}

}  // namespace asperity
