#pragma once

#include "core/Vector.h"

#include <vtkSmartPointer.h>

#include <optional>

class vtkRenderer;

namespace asperity {

class Painter;
class PainterItem;

/// What is written over the view.
struct LabelContent {
    double metersPerPixel = 0.0;      ///< of the screen's coordinates; 0: nothing is written
    double magnification = 1.0;       ///< of displacements; said when it is not 1
    double force = 0.0;               ///< magnitude [N]
    std::optional<Vector3> forceEnd;  ///< where its label belongs; empty: no label [m]
};

/// Scale bar, magnification and force, painted over a view.
class ViewLabels {
public:
    /// @param renderer outlives this object
    explicit ViewLabels(vtkRenderer* renderer);
    ~ViewLabels();
    ViewLabels(const ViewLabels&) = delete;
    ViewLabels& operator=(const ViewLabels&) = delete;

    /// @param pixelRatio drawn pixels per pixel of the screen's coordinates
    void setPixelRatio(double pixelRatio);
    void show(const LabelContent& content) { content_ = content; }
    void hide() { content_ = {}; }

private:
    void paint(Painter& painter) const;
    void paintScaleBar(Painter& painter) const;
    void paintForce(Painter& painter, double viewWidth, double viewHeight) const;

    vtkRenderer* renderer_;
    vtkSmartPointer<PainterItem> item_;
    double pixelRatio_ = 1.0;
    LabelContent content_;
};

}  // namespace asperity
