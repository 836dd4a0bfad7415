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

struct Scene;

/// Pose of the drawn lever.
struct LeverPose {
    Vector3 shankTop = Vector3::Zero();  ///< middle of the shank's flat end, as drawn [m]
    double size = 0.0;                   ///< half the lever's width, as drawn [m]
    double azimuth = 0.0;                ///< of the way from clamp to free end, from x [rad]
    double tilt = 0.0;                   ///< free end down [rad]
};

/// The end of the lever above the tip: a slab that shows where the lever comes from. Its size is
/// that of the picture: a real lever is some ten thousand times as long as a contact is wide.
class LeverLayer {
public:
    explicit LeverLayer(vtkRenderer* renderer);
    ~LeverLayer();
    LeverLayer(const LeverLayer&) = delete;
    LeverLayer& operator=(const LeverLayer&) = delete;

    void show(const LeverPose& lever, const Shading& shading);
    void hide();

private:
    vtkNew<vtkPolyData> data_;
    vtkSmartPointer<vtkActor> slab_;
};

/// Parameters with which the tip is drawn.
struct TipStyle {
    double height = 0.0;           ///< of the part that is drawn, as drawn [m]
    double paraboloidReach = 0.0;  ///< see vtkAspTipSource [m]
    double opacity = 1.0;          ///< of its body
    DrawnSpace space;
    Shading shading;
};

/// The tip as a solid body, upright, in touch with the surface; far from it, a thin line from the
/// tip's apex to the position below it.
class TipLayer {
public:
    explicit TipLayer(vtkRenderer* renderer);
    ~TipLayer();
    TipLayer(const TipLayer&) = delete;
    TipLayer& operator=(const TipLayer&) = delete;

    void show(const ContactShape& shape, const TipStyle& style);
    void hide();

    /// Body that is drawn, world frame.
    [[nodiscard]] vtkPolyData* body() const { return body_; }

private:
    void deform(const ContactShape& shape);
    void showDrop(const ContactShape& shape);

    vtkNew<vtkAspTipSource> source_;
    vtkNew<vtkPolyData> body_;
    vtkSmartPointer<vtkActor> solid_;
    vtkSmartPointer<vtkActor> drop_;
};

/// Lowest point of the tip at rest, world [m].
[[nodiscard]] Vector3 apexOf(const TipContact& contact);

/// Size at which the tip is drawn.
struct GearScale {
    double halfWidth = 0.0;        ///< of the frame [m]
    double tipRadius = 0.0;        ///< [m]
    double paraboloidReach = 0.0;  ///< see ViewScale [m]
    double heightScale = 1.0;      ///< see DrawnSpace

    /// A tip that would fill the frame: only the lowest part of it is drawn, and is seen through.
    [[nodiscard]] bool isCap() const { return tipRadius > halfWidth; }
    /// Size of tip and arrow as drawn: as the frame up close, less of it from afar [m].
    [[nodiscard]] double size() const;
    /// Height of the tip above its apex, as drawn [m].
    [[nodiscard]] double tipHeight() const;
    /// Height that tip and arrow take above the surface, as drawn [m].
    [[nodiscard]] double headroom() const;
    /// Farther out than the tip alone.
    [[nodiscard]] bool showsLever() const;
};

/// The tip, from afar with the end of its lever.
class TipGear {
public:
    explicit TipGear(vtkRenderer* renderer) : tip_(renderer), lever_(renderer) {}

    void show(const Scene& scene, const ContactShape& shape, const GearScale& scale,
              const DrawnSpace& space, const Shading& shading);
    void hide();

    /// The tip as it is drawn, world frame.
    [[nodiscard]] vtkPolyData* body() const { return tip_.body(); }

private:
    TipLayer tip_;
    LeverLayer lever_;
};

}  // namespace asperity
