#include "core/probe/CantileverShape.h"

#include <algorithm>

namespace asperity {

namespace {

/// Shape between clamp and tip.
CantileverShape loadedShape(const Cantilever& cantilever, const Vector3& local, double distance) {
    const CantileverGeometry& beam = cantilever.geometry();
    const double length = beam.loadPoint();
    const double flexibility = 2.0 * cantilever.bendingPerFz() / (length * length);  // 1 / (E I)
    const double ratio = beam.thickness / beam.width;
    const double square = distance * distance;
    const double underEndLoad = square * ((length / 2.0) - (distance / 6.0));
    const double slopeUnderEndLoad = distance * (length - (distance / 2.0));
    const double endMoment = beam.tipHeight * local.x();
    const double lateralLoad = flexibility * ratio * ratio * local.y();
    return {.deflection = flexibility * ((local.z() * underEndLoad) + (endMoment * square / 2.0)),
            .slope = flexibility * ((local.z() * slopeUnderEndLoad) + (endMoment * distance)),
            .lateralDeflection = lateralLoad * underEndLoad,
            .lateralSlope = lateralLoad * slopeUnderEndLoad,
            .torsion = cantilever.torsionPerFy() * local.y() * distance / length};
}

}  // namespace

CantileverShape cantileverShape(const Cantilever& cantilever, const Vector3& force,
                                double distance) noexcept {
    const double loaded = std::min(distance, cantilever.geometry().loadPoint());
    CantileverShape shape = loadedShape(cantilever, cantilever.rotation() * force, loaded);
    shape.deflection += shape.slope * (distance - loaded);
    shape.lateralDeflection += shape.lateralSlope * (distance - loaded);
    return shape;
}

}  // namespace asperity
