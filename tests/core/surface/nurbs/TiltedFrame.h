#pragma once

#include "core/Units.h"
#include "core/surface/nurbs/NurbsShapes.h"

namespace asperity::test {

/// Radius and frame of spheres, cylinders and tori: away from the origin, its axis along y.
inline constexpr double kRadius = 200.0_nm;
inline const RevolutionFrame kFrame{.center = Vector3(100.0_nm, -50.0_nm, 200.0_nm),
                                    .first = -Vector3::UnitZ(),
                                    .second = -Vector3::UnitX()};

}  // namespace asperity::test
