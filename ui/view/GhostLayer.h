#pragma once

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
    explicit TipGhosts(vtkRenderer* through) : commanded_(through), true_(through) {}

    /// Shows those that the options ask for.
    /// @param commanded, trueTip apex, world [m]; none: not known
    void show(const ViewOptions& options, const std::optional<Vector3>& commanded,
              const std::optional<Vector3>& trueTip, GhostStyle style);
    void hide() { show({}, {}, {}, {}); }
    /// Names of the ghosts that are shown.
    [[nodiscard]] const std::vector<LabelContent::Name>& names() const { return names_; }

private:
    GhostLayer commanded_;
    GhostLayer true_;
    std::vector<LabelContent::Name> names_;
};

}  // namespace asperity
