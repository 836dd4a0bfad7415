#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/Shading.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkActor;
class vtkAspTipSource;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

/// How the tip is drawn.
struct TipStyle {
    double top = 0.0;                  ///< of the tip above the surface [m]
    Vector3 toEye = Vector3::UnitZ();  ///< unit
    Shading shading;
};

/// The tip as a body of glass that fades out upwards, in touch with the surface as the surface
/// is drawn; far from it, a thin line from the tip's apex to the place below it.
class TipLayer {
public:
    explicit TipLayer(vtkRenderer* renderer);
    ~TipLayer();
    TipLayer(const TipLayer&) = delete;
    TipLayer& operator=(const TipLayer&) = delete;

    /// @param magnification of distances from the surface at rest
    void show(const ContactShape& shape, double magnification, const TipStyle& style);
    void hide();

private:
    void deform(const ContactShape& shape);
    void makeGlass(const Vector3& apex, double height, const TipStyle& style);
    void showDrop(const ContactShape& shape, const Vector3& apex);

    vtkNew<vtkAspTipSource> source_;
    vtkNew<vtkPolyData> body_;
    std::array<vtkSmartPointer<vtkActor>, 2> walls_;  ///< the far one, the near one
    vtkSmartPointer<vtkActor> drop_;
};

}  // namespace asperity
