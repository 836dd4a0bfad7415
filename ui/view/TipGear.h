#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/LeverLayer.h"
#include "ui/view/Shading.h"
#include "ui/view/TipLayer.h"

namespace asperity {

struct Scene;

/// How large the tip is drawn.
struct GearScale {
    double halfWidth = 0.0;        ///< of the frame [m]
    double tipRadius = 0.0;        ///< [m]
    double paraboloidReach = 0.0;  ///< see ViewScale [m]
    double heightScale = 1.0;      ///< see DrawnSpace

    /// A tip that would fill the frame: only the lowest part of it is drawn, and is seen through.
    [[nodiscard]] bool isCap() const { return tipRadius > halfWidth; }
    /// Of tip and arrow as drawn: as the frame up close, less of it from afar [m].
    [[nodiscard]] double size() const;
    /// Of the tip above its apex, as drawn [m].
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
