#pragma once

#include "core/surface/BSplineSurface.h"
#include "ui/ColorScale.h"
#include "ui/Steady.h"
#include "vtkplugins/pictures/Color.h"

#include <vtkSmartPointer.h>

class vtkLookupTable;

namespace asperity {

/// The colors of a surface: height where it is at rest, going over into displacement where the
/// tip has moved it. Ranges seldom change.
class SurfaceColors {
public:
    SurfaceColors();

    /// Fits the range of heights [m]. @return whether it changed
    bool fitHeights(double low, double high);
    /// Fits the range of displacements to their largest magnitude [m]. @return whether it changed
    bool fitDisplacement(double largest);

    [[nodiscard]] const AxisRange& heightRange() const { return heightRange_.range(); }  ///< [m]
    /// Color of a height at rest [m]. @param displacement into the sample [m]
    [[nodiscard]] Color at(double height, double displacement = 0.0) const;
    /// Color of a place of the surface at rest; where the scan holds no data, heights filled in
    /// have no color of a height.
    [[nodiscard]] Color of(const BSplineSurface& surface, const Vector3& rest,
                           double displacement = 0.0) const;

    [[nodiscard]] ColorScale heightScale() const;
    [[nodiscard]] ColorScale displacementScale() const;

private:
    [[nodiscard]] Color moved(const Color& rest, double displacement) const;

    SteadyRange heightRange_;
    SteadyRange displacementRange_;
    vtkSmartPointer<vtkLookupTable> heights_;
    vtkSmartPointer<vtkLookupTable> displacements_;
};

}  // namespace asperity
