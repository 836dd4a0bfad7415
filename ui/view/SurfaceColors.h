#pragma once

#include "core/deformation/SurfaceField.h"
#include "core/surface/BSplineSurface.h"
#include "ui/view/ColorScale.h"
#include "ui/view/ContactShape.h"
#include "ui/widgets/Steady.h"
#include "vtkplugins/pictures/ColorMaps.h"
#include "vtkplugins/pictures/Palette.h"

#include <span>
#include <vector>

namespace asperity {

struct Scene;

/// The colors of a surface: those of one quantity. Heights go over into displacement where the tip
/// has moved the surface. Ranges seldom change.
class SurfaceColors {
public:
    SurfaceColors();

    /// @param field what the look's quantity is on the surface at rest; of another quantity: it is
    /// shown in its own colors
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    [[nodiscard]] const SurfaceField& field() const { return field_; }
    /// Another number for each call of setLook() with another field.
    [[nodiscard]] int fieldNumber() const { return fieldNumber_; }
    /// Returns whether the quantity changes with the tip: then the colors around it are those of
    /// ofLive().
    [[nodiscard]] bool isLive() const { return field_.isLive(); }

    /// Another scene: ranges that are not pinned are those of its values alone.
    void forgetScene();
    /// Fits the heights that the view has room for [m]. @return whether that changed
    bool fitHeights(double low, double high);
    /// Returns whether of all values only the lowest and highest matter, and they are those of
    /// heights.
    [[nodiscard]] bool needsEnds() const;
    /// Fits the colors to the field's values in the view. @return whether the colors changed
    bool fitRest(std::span<const double> values);
    /// Fits the range of displacements to their largest magnitude [m]. @return whether it changed
    bool fitDisplacement(double largest);
    /// Fits the colors to the values around the tip. @return whether the colors changed
    bool fitLive(std::span<const double> values);

    [[nodiscard]] const AxisRange& heightRange() const { return heightRange_.range(); }  ///< [m]
    /// Color of a value of the field; of none where it is not a number.
    [[nodiscard]] Color ofRest(double value) const;
    /// Color of a position with this value at rest that the tip has moved. Heights alone show it.
    /// @param displacement into the sample [m]
    [[nodiscard]] Color ofDeformed(double value, double displacement) const;
    [[nodiscard]] Color ofLive(double value) const;
    /// Returns the part that the displacement's color has of it, 0 .. 1. @param displacement [m]
    [[nodiscard]] double movedShare(double displacement) const;

    /// Color scale of the quantity.
    [[nodiscard]] ColorScale scale() const;
    /// Color scale of displacements over heights; without colors where another quantity is shown.
    [[nodiscard]] ColorScale displacementScale() const;

private:
    [[nodiscard]] Color moved(const Color& rest, double displacement) const;
    [[nodiscard]] const QuantityColors& chosen() const { return look_.of(field_.quantity()); }
    [[nodiscard]] const ColorRange& range() const { return ranges_.of(field_.quantity()); }
    bool fit(std::span<const double> values, bool isSteady);
    [[nodiscard]] QString liveNote() const;

    SurfaceLook look_;
    SurfaceField field_;
    int fieldNumber_ = 0;
    SteadyRange heightRange_;
    SteadyRange displacementRange_;
    ColorRanges ranges_;
    ColorTable table_;
    ColorTable displacements_;
};

/// The field's values at positions of the surface; not a number where the scan holds no data.
[[nodiscard]] double valueAt(const SurfaceField& field, const BSplineSurface& surface,
                             const Vector3& rest, const Vector3& normal);

/// Colors of the surface around the contact, at one tick: of its samples and of other positions.
class PatchColors {
public:
    /// All outlive this object. @param colors whose ranges may change afterwards
    PatchColors(const Scene& scene, const ContactShape& shape, const SurfaceColors& colors);

    /// The quantity at the shape's samples; where it does not change with the tip, that at rest.
    [[nodiscard]] std::span<const double> values() const { return values_; }
    /// Color of a sample of the shape.
    [[nodiscard]] Color of(std::size_t sample) const;
    /// Returns the part that the displacement's color has of it, 0 .. 1.
    [[nodiscard]] double movedShare(std::size_t sample) const {
        return colors_.movedShare(shape_.displacements()[sample]);
    }
    /// Color of another position. @param normal of the surface at rest
    [[nodiscard]] Color of(const Vector3& rest, const Vector3& normal, double displacement) const;
    /// A field near the tip, as the contact changes it; not a number where it has none.
    [[nodiscard]] static double valueOf(const Scene& scene, const ContactShape& shape,
                                        const SurfaceField& field, const Vector3& rest,
                                        const Vector3& normal, double displacement);

private:
    [[nodiscard]] Color colorOf(double value, double displacement) const;

    const Scene& scene_;
    const ContactShape& shape_;
    const SurfaceColors& colors_;
    std::vector<double> values_;
};

}  // namespace asperity
