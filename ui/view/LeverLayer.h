#pragma once

#include "ui/view/Shading.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

/// Where the drawn lever sits.
struct LeverPlace {
    Vector3 shankTop = Vector3::Zero();  ///< middle of the shank's flat end, as drawn [m]
    double size = 0.0;                   ///< half the lever's width, as drawn [m]
    double azimuth = 0.0;                ///< of the way from clamp to free end, from x [rad]
    double tilt = 0.0;                   ///< free end down [rad]
};

/// The end of the lever above the tip: a slab that shows where the lever comes from. Its size is
/// that of the picture: a real lever is some ten thousand times as long as a contact is wide.
class LeverLayer {
public:
    explicit LeverLayer(vtkRenderer* renderer);
    ~LeverLayer();
    LeverLayer(const LeverLayer&) = delete;
    LeverLayer& operator=(const LeverLayer&) = delete;

    void show(const LeverPlace& place, const Shading& shading);
    void hide();

private:
    vtkNew<vtkPolyData> data_;
    vtkSmartPointer<vtkActor> slab_;
};

}  // namespace asperity
