#include "ui/view/PatchColors.h"

#include "core/scene/Scene.h"

namespace asperity {

PatchColors::PatchColors(const Scene& scene, const ContactShape& shape, const SurfaceColors& colors)
    : scene_(scene), shape_(shape), colors_(colors) {
    const SurfacePatch& patch = shape.patch();
    values_.reserve(patch.rest.size());
    for (std::size_t i = 0; i < patch.rest.size(); ++i) {
        values_.push_back(valueOf(scene, shape, colors.field(), patch.rest[i], patch.normals[i],
                                  shape.displacements()[i]));
    }
}

Color PatchColors::of(std::size_t sample) const {
    return colorOf(values_[sample], shape_.displacements()[sample]);
}

Color PatchColors::of(const Vector3& rest, const Vector3& normal, double displacement) const {
    return colorOf(valueOf(scene_, shape_, colors_.field(), rest, normal, displacement),
                   displacement);
}

double PatchColors::valueOf(const Scene& scene, const ContactShape& shape,
                            const SurfaceField& field, const Vector3& rest, const Vector3& normal,
                            double displacement) {
    switch (field.quantity()) {
    case SurfaceQuantity::Gap:
        return shape.gap(rest, displacement);
    case SurfaceQuantity::Pressure:
        return shape.pressure(rest);
    case SurfaceQuantity::Displacement:
        return displacement;
    default:
        return valueAt(field, scene.surface, rest, normal);
    }
}

Color PatchColors::colorOf(double value, double displacement) const {
    return colors_.isLive() ? colors_.ofLive(value) : colors_.ofDeformed(value, displacement);
}

}  // namespace asperity
