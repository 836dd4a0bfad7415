#pragma once

#include "core/Vector.h"
#include "core/deformation/HalfSpaceAnswer.h"
#include "ui/view/SurfaceColors.h"
#include "ui/view/ViewCamera.h"
#include "ui/view/ViewOptions.h"

#include <memory>
#include <optional>

namespace asperity {

/// How a view of the window shows its scene, so that a picture can show it alike.
struct ShownView {
    ViewCamera camera;
    ViewOptions options;
    double halfWidth = 0.0;                            ///< of the frame [m]
    SurfaceColors colors;                              ///< with the ranges that they have there
    std::optional<Vector3> trueTip;                    ///< see Snapshot [m]
    std::shared_ptr<const HalfSpaceAnswer> halfSpace;  ///< null: none is drawn
};

}  // namespace asperity
