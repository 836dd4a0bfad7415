#pragma once

#include "core/scene/Marker.h"
#include "core/surface/BSplineSurface.h"
#include "ui/view/DrawnSpace.h"
#include "ui/view/ViewLabels.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkRenderer;

namespace asperity {

/// The markers of a scene that lie in the part of the scan that is shown: crosses on the surface at
/// rest, with their names.
class MarkerLayer {
public:
    explicit MarkerLayer(vtkRenderer* renderer);
    ~MarkerLayer();
    MarkerLayer(const MarkerLayer&) = delete;
    MarkerLayer& operator=(const MarkerLayer&) = delete;

    void show(const std::vector<Marker>& markers, const BSplineSurface& surface,
              const ScanWindow& window, const DrawnSpace& space);
    void hide();
    /// Of those that are shown.
    [[nodiscard]] const std::vector<LabelContent::Name>& names() const { return names_; }

private:
    vtkSmartPointer<vtkActor> lines_;
    std::vector<LabelContent::Name> names_;
};

}  // namespace asperity
