#pragma once

#include "ui/view/SeenOutline.h"
#include "ui/view/Shading.h"
#include "ui/view/ViewFrame.h"
#include "ui/view/ViewLabels.h"
#include "vtkplugins/pictures/Palette.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

class vtkActor;
class vtkAspTipSource;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

/// Parameters with which a ghost is drawn.
struct GhostStyle {
    double radius = 0.0;           ///< of the tip [m]
    double shankHalfAngle = 0.0;   ///< [rad]
    double paraboloidReach = 0.0;  ///< see vtkAspTipSource [m]
    SeenAxes axes;                 ///< of the view
    DrawnSpace space;
};

/// A faint tip with its outline, where the tip is not but could be. Ghosts lie over all else in
/// their renderer and over each other in a fixed order, not by their depth: noise moves ghosts that
/// nearly coincide with each other, or with the dent, before and behind each other in every frame.
class GhostLayer {
public:
    /// @param through what is drawn there shows through everything
    /// @param rank    1: over all but ghosts; 2: over the first ghost
    GhostLayer(vtkRenderer* through, int rank);
    ~GhostLayer();
    GhostLayer(const GhostLayer&) = delete;
    GhostLayer& operator=(const GhostLayer&) = delete;

    /// @param apex   world [m]
    /// @param height of the part that is drawn, as drawn [m]
    void show(const Vector3& apex, double height, const GhostStyle& style, const Color& color);
    void hide();
    /// Position of its name: the right end of its outline, as drawn [m].
    [[nodiscard]] const Vector3& labelPosition() const { return labelPosition_; }

private:
    vtkNew<vtkAspTipSource> source_;
    vtkNew<vtkPolyData> body_;
    vtkSmartPointer<vtkActor> solid_;
    vtkSmartPointer<vtkActor> outline_;
    Vector3 labelPosition_ = Vector3::Zero();
};

/// The ghosts of the tip: where it would be without forces, and where it really is.
class TipGhosts {
public:
    /// @param through what is drawn there shows through everything
    explicit TipGhosts(vtkRenderer* through) : true_(through, 1), commanded_(through, 2) {}

    /// Where a ghost is, and how much of it is drawn.
    struct Pose {
        Vector3 apex = Vector3::Zero();  ///< world [m]
        double height = 0.0;             ///< as drawn [m]
    };
    /// Shows those that there are.
    void show(const std::optional<Pose>& commanded, const std::optional<Pose>& trueTip,
              const GhostStyle& style);
    void hide() { show({}, {}, {}); }
    /// Names of the ghosts that are shown.
    [[nodiscard]] const std::vector<LabelContent::Name>& names() const { return names_; }

private:
    GhostLayer true_;
    GhostLayer commanded_;
    std::vector<LabelContent::Name> names_;
};

}  // namespace asperity
