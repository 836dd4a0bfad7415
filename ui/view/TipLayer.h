#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/Shading.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkAspTipSource;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

/// How the tip is drawn.
struct TipStyle {
    double height = 0.0;           ///< of the part that is drawn, as drawn [m]
    double paraboloidReach = 0.0;  ///< see vtkAspTipSource [m]
    double opacity = 1.0;          ///< of its body
    DrawnSpace space;
    Shading shading;
};

/// The tip as a solid body, upright, in touch with the surface; far from it, a thin line from the
/// tip's apex to the place below it.
class TipLayer {
public:
    explicit TipLayer(vtkRenderer* renderer);
    ~TipLayer();
    TipLayer(const TipLayer&) = delete;
    TipLayer& operator=(const TipLayer&) = delete;

    void show(const ContactShape& shape, const TipStyle& style);
    void hide();

    /// What is drawn, world frame.
    [[nodiscard]] vtkPolyData* body() const { return body_; }

private:
    void deform(const ContactShape& shape);
    void showDrop(const ContactShape& shape);

    vtkNew<vtkAspTipSource> source_;
    vtkNew<vtkPolyData> body_;
    vtkSmartPointer<vtkActor> solid_;
    vtkSmartPointer<vtkActor> drop_;
};

/// Lowest place of the tip at rest, world [m].
[[nodiscard]] Vector3 apexOf(const TipContact& contact);

}  // namespace asperity
