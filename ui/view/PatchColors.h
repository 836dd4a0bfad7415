#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/SurfaceColors.h"

#include <span>
#include <vector>

namespace asperity {

struct Scene;

/// The colors of the surface around the contact, at one tick: of its samples and of other places.
class PatchColors {
public:
    /// All outlive this object. @param colors whose ranges may change afterwards
    PatchColors(const Scene& scene, const ContactShape& shape, const SurfaceColors& colors);

    /// The quantity at the shape's samples; where it does not change with the tip, that at rest.
    [[nodiscard]] std::span<const double> values() const { return values_; }
    /// Of a sample of the shape.
    [[nodiscard]] Color of(std::size_t sample) const;
    /// Of another place. @param normal of the surface at rest
    [[nodiscard]] Color of(const Vector3& rest, const Vector3& normal, double displacement) const;
    /// A field at a place near the tip, as the contact changes it; not a number where it has none.
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
