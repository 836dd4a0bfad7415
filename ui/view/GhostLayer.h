#pragma once

#include "ui/view/DrawnSpace.h"
#include "vtkplugins/pictures/Color.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkAspTipSource;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

/// How a ghost is drawn.
struct GhostStyle {
    double radius = 0.0;               ///< of the tip [m]
    double shankHalfAngle = 0.0;       ///< [rad]
    double height = 0.0;               ///< of the part that is drawn, as drawn [m]
    double paraboloidReach = 0.0;      ///< see vtkAspTipSource [m]
    Vector3 right = Vector3::UnitX();  ///< rightwards in the view, unit
    Vector3 up = Vector3::UnitZ();     ///< upwards in the view, unit
    DrawnSpace space;
    Color color;
};

/// A faint tip with its outline, where the tip is not but could be.
class GhostLayer {
public:
    /// @param through what is drawn there shows through everything
    explicit GhostLayer(vtkRenderer* through);
    ~GhostLayer();
    GhostLayer(const GhostLayer&) = delete;
    GhostLayer& operator=(const GhostLayer&) = delete;

    /// @param apex world [m]
    void show(const Vector3& apex, const GhostStyle& style);
    void hide();
    /// Where its name belongs: the right end of its outline, as drawn [m].
    [[nodiscard]] const Vector3& labelPlace() const { return labelPlace_; }

private:
    vtkNew<vtkAspTipSource> source_;
    vtkNew<vtkPolyData> body_;
    vtkSmartPointer<vtkActor> solid_;
    vtkSmartPointer<vtkActor> outline_;
    Vector3 labelPlace_ = Vector3::Zero();
};

}  // namespace asperity
