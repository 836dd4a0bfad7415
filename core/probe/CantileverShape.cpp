#include "core/probe/CantileverShape.h"

namespace asperity {

CantileverShape cantileverShape(const Cantilever& cantilever, const Vector3& force,
                                double distance) noexcept {
    const CantileverGeometry& beam = cantilever.geometry();
    const Vector3 local = cantilever.rotation() * force;
    const double flexibility =
        2.0 * cantilever.bendingPerFz() / (beam.length * beam.length);  // 1 / (E I)
    const double ratio = beam.thickness / beam.width;
    const double square = distance * distance;
    const double underEndLoad = square * ((beam.length / 2.0) - (distance / 6.0));
    const double endMoment = beam.tipHeight * local.x();
    return {.deflection = flexibility * ((local.z() * underEndLoad) + (endMoment * square / 2.0)),
            .slope = flexibility * ((local.z() * distance * (beam.length - (distance / 2.0))) +
                                    (endMoment * distance)),
            .lateralDeflection = flexibility * ratio * ratio * local.y() * underEndLoad,
            .torsion = cantilever.torsionPerFy() * local.y() * distance / beam.length};
}

}  // namespace asperity
