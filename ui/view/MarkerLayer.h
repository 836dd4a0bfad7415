#pragma once

#include "core/scene/SceneDescription.h"
#include "core/scene/Settings.h"
#include "core/surface/BSplineSurface.h"
#include "ui/view/ContactShape.h"
#include "ui/view/ViewFrame.h"
#include "ui/view/ViewLabels.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

class vtkActor;
class vtkRenderer;

namespace asperity {

class BSplineSurface;
struct Scene;

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

/// Two lines along x and y that cross at a position of the surface and lie on it, deformed or not.
class CrossHairLayer {
public:
    explicit CrossHairLayer(vtkRenderer* renderer);
    ~CrossHairLayer();
    CrossHairLayer(const CrossHairLayer&) = delete;
    CrossHairLayer& operator=(const CrossHairLayer&) = delete;

    /// @param window  of the scan, across which the lines run
    /// @param contact where the surface is deformed; null: nowhere
    void show(const BSplineSurface& surface, const Vector2& position, const ScanWindow& window,
              const ContactShape* contact, const DrawnSpace& space);
    void hide();

private:
    vtkSmartPointer<vtkActor> lines_;
};

/// Target of the tip's apex: a cross-hair in space, and a ring on the surface below or above it,
/// which shows its height.
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
    /// Name and its position; none while the target is hidden.
    [[nodiscard]] const std::optional<LabelContent::Name>& name() const { return name_; }

private:
    vtkSmartPointer<vtkActor> edge_;  ///< dark, so that it is seen on every color
    vtkSmartPointer<vtkActor> lines_;
    std::optional<LabelContent::Name> name_;
};

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
    /// Names of the markers that are shown.
    [[nodiscard]] const std::vector<LabelContent::Name>& names() const { return names_; }

private:
    vtkSmartPointer<vtkActor> lines_;
    std::vector<LabelContent::Name> names_;
};

}  // namespace asperity
