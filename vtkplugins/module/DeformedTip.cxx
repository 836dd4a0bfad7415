#include "vtkplugins/module/DeformedTip.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace asperity {

void deformTip(vtkPolyData& tip, const Vector3& center, const Vector3& outward,
               const RadialDisplacement& displacement) {
    if (!displacement) {
        return;
    }
    for (vtkIdType id = 0; id < tip.GetNumberOfPoints(); ++id) {
        const Vector3 point(tip.GetPoint(id));
        const Vector3 arm = point - center;
        const double distance = (arm - arm.dot(outward) * outward).norm();
        const Vector3 moved = point + displacement(distance) * outward;
        tip.GetPoints()->SetPoint(id, moved.data());
    }
}

}  // namespace asperity
