#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/DrawnSpace.h"

#include <vtkSmartPointer.h>

class vtkActor;
class vtkRenderer;

namespace asperity {

struct Scene;

/// Two lines along x and y that cross at a place of the surface and lie on it, deformed or not.
class CrossHairLayer {
public:
    explicit CrossHairLayer(vtkRenderer* renderer);
    ~CrossHairLayer();
    CrossHairLayer(const CrossHairLayer&) = delete;
    CrossHairLayer& operator=(const CrossHairLayer&) = delete;

    /// @param window  of the scan, across which the lines run
    /// @param contact where the surface is deformed; null: nowhere
    void show(const BSplineSurface& surface, const Vector2& place, const ScanWindow& window,
              const ContactShape* contact, const DrawnSpace& space);
    void hide();

private:
    vtkSmartPointer<vtkActor> lines_;
};

}  // namespace asperity
