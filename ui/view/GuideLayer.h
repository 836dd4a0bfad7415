#pragma once

#include "core/scene/VirtualFixture.h"
#include "ui/view/DrawnSpace.h"

#include <vtkSmartPointer.h>

class vtkActor;
class vtkRenderer;

namespace asperity {

/// The guide that helps the device to hold a target: a small cross for a point, a line, a framed
/// square with its middle lines for a plane.
class GuideLayer {
public:
    explicit GuideLayer(vtkRenderer* renderer);
    ~GuideLayer();
    GuideLayer(const GuideLayer&) = delete;
    GuideLayer& operator=(const GuideLayer&) = delete;

    /// @param reach to which lines and planes are drawn on each side of the point [m]
    void show(const VirtualFixture& guide, double reach, const DrawnSpace& space);
    void hide();

private:
    vtkSmartPointer<vtkActor> lines_;
};

}  // namespace asperity
