#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/SeenOutline.h"
#include "ui/view/Shading.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <limits>

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

/// The end of the lever above the tip: a slab that shows where the lever comes from, and fades away
/// towards its clamp. Its size is that of the picture: a real lever is some ten thousand times as
/// long as a contact is wide.
class LeverLayer {
public:
    explicit LeverLayer(vtkRenderer* renderer);
    ~LeverLayer();
    LeverLayer(const LeverLayer&) = delete;
    LeverLayer& operator=(const LeverLayer&) = delete;

    void show(const LeverPose& lever, const Shading& shading);
    void hide();
    /// Returns how far it reaches above the shank's end along a direction of the view, as drawn
    /// [m].
    [[nodiscard]] static double rise(const LeverPose& lever, const Vector3& up);

private:
    vtkNew<vtkPolyData> data_;
    vtkSmartPointer<vtkActor> slab_;
};

/// Opacity of the tip over its height: the contact shows through its lower end, and at the top,
/// where the real tip goes on beyond the picture, it fades away. World z [m].
struct TipOpacity {
    double apex = 0.0;
    double clear = 0.0;  ///< height above the apex of what the contact shows through [m]
    double top = 0.0;    ///< where nothing of it is seen
    bool isCap = false;  ///< all of it is seen through
    bool isOpen = true;  ///< it fades away at the top

    /// Returns the opacity that the fading at the top leaves, 0 .. 1.
    [[nodiscard]] double fading(double z) const;
    [[nodiscard]] double at(double z) const;
};

/// Parameters with which the tip is drawn.
struct TipStyle {
    double height = 0.0;           ///< of the part that is drawn, as drawn [m]
    double paraboloidReach = 0.0;  ///< see vtkAspTipSource [m]
    bool isCap = false;            ///< see GearScale
    bool isOpen = true;            ///< see TipOpacity
    SeenAxes axes;                 ///< of the view
    DrawnSpace space;
    Shading shading;
};

/// The tip as a polished body, upright, in touch with the surface, with an edge around it; far from
/// the surface, a thin line from the tip's apex to the position below it.
class TipLayer {
public:
    explicit TipLayer(vtkRenderer* renderer);
    ~TipLayer();
    TipLayer(const TipLayer&) = delete;
    TipLayer& operator=(const TipLayer&) = delete;

    void show(const ContactShape& shape, const TipStyle& style);
    void hide();

    /// Body that is drawn, closed at its top, world frame.
    [[nodiscard]] vtkPolyData* body() const { return body_; }
    [[nodiscard]] const TipOpacity& opacity() const { return opacity_; }

private:
    void deform(const ContactShape& shape);
    void paintBody(const Shading& shading);
    void showEdge(const TipStyle& style);
    void showDrop(const ContactShape& shape);

    vtkNew<vtkAspTipSource> source_;
    vtkNew<vtkPolyData> body_;
    TipOpacity opacity_;
    std::array<vtkSmartPointer<vtkActor>, 2> walls_;  ///< far and near
    vtkSmartPointer<vtkActor> edge_;
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
    /// Height above the apex at which the tip leaves the picture, as drawn [m].
    double room = std::numeric_limits<double>::infinity();

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
              const SeenAxes& axes, const DrawnSpace& space, const Shading& shading);
    void hide();

    /// See TipLayer.
    [[nodiscard]] vtkPolyData* body() const { return tip_.body(); }
    [[nodiscard]] const TipOpacity& opacity() const { return tip_.opacity(); }

private:
    TipLayer tip_;
    LeverLayer lever_;
};

}  // namespace asperity
