#pragma once

#include "ui/view/DrawnSpace.h"
#include "ui/view/ViewLabels.h"

#include <vtkSmartPointer.h>

#include <optional>

class vtkActor;
class vtkRenderer;

namespace asperity {

class BSplineSurface;

/// Where the tip's apex shall be: a cross-hair in space, and a ring on the surface below or above
/// it, from which its height is seen.
class TargetLayer {
public:
    /// @param through what is drawn there shows through everything
    explicit TargetLayer(vtkRenderer* through);
    ~TargetLayer();
    TargetLayer(const TargetLayer&) = delete;
    TargetLayer& operator=(const TargetLayer&) = delete;

    /// @param arm of the cross-hair [m]
    void show(const Vector3& target, const BSplineSurface& surface, double arm,
              const DrawnSpace& space);
    void hide();
    /// What it is called, and where; none while it is hidden.
    [[nodiscard]] const std::optional<LabelContent::Name>& name() const { return name_; }

private:
    vtkSmartPointer<vtkActor> edge_;  ///< dark, so that it is seen on every color
    vtkSmartPointer<vtkActor> lines_;
    std::optional<LabelContent::Name> name_;
};

}  // namespace asperity
