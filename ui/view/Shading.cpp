#include "ui/view/Shading.h"

#include "ui/widgets/Theme.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// Light that a polished body sends to the eye: from all around, from what faces the eye, from the
/// light, and the highlight's.
constexpr double kPolishedAround = 0.44;
constexpr double kPolishedFacing = 0.46;
constexpr double kPolishedLit = 0.30;
constexpr double kPolishedGlint = 0.30;
constexpr double kInside = 0.8;  // of a far wall that is seen from inside

// Rightwards part of a normal.
constexpr double kGlintAt = 0.6;  // of the light's own
constexpr double kGlintWidth = 0.24;

}  // namespace

Vector3 Light::direction() const {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const double flat = std::cos(kDegree * elevation);
    return {flat * std::cos(kDegree * azimuth), flat * std::sin(kDegree * azimuth),
            std::sin(kDegree * elevation)};
}

Shading::Shading(const ViewCamera& camera, const DrawnSpace& space, const Light& light)
    : space_(space), toLight_(light.direction()) {
    toView_.row(0) = camera.right();
    toView_.row(1) = camera.up();
    toView_.row(2) = camera.out();
}

std::array<unsigned char, 3> Shading::lit(const Color& color, const Vector3& normal,
                                          const Matt& matt) const {
    const Vector3 seen = toView_ * space_.normal(normal);
    const double light = brightness(isUnderside(seen) ? Vector3(-seen) : seen, toLight_, matt);
    const auto shade = [light](std::uint8_t part) {
        return static_cast<unsigned char>(std::min(255.0, light * part + 0.5));
    };
    return {shade(color.red), shade(color.green), shade(color.blue)};
}

std::array<unsigned char, 3> Shading::litSurface(const Color& color, const Vector3& normal) const {
    return isUnderside(toView_ * space_.normal(normal))
               ? lit(theme::palette().side, normal, kWallMatt)
               : lit(color, normal);
}

std::array<unsigned char, 3> Shading::polished(const Color& color, const Vector3& normal) const {
    const Vector3 seen = toView_ * space_.normal(normal);
    const double facing = seen.z() < 0.0 ? -kInside * seen.z() : seen.z();
    const double light = kPolishedAround + (kPolishedFacing * facing) +
                         (kPolishedLit * std::max(0.0, seen.dot(toLight_)));
    const double beside = (seen.x() - (kGlintAt * toLight_.x())) / kGlintWidth;
    const double highlight = 255.0 * kPolishedGlint * facing * std::exp(-beside * beside);
    const auto shade = [&](std::uint8_t part) {
        return static_cast<unsigned char>(std::min(255.0, light * part + highlight + 0.5));
    };
    return {shade(color.red), shade(color.green), shade(color.blue)};
}

/// Seen from above, the surface hides its own back faces.
bool Shading::isUnderside(const Vector3& seenNormal) const {
    const bool isFromBelow = toView_(2, 2) < 0.0;
    return isFromBelow && seenNormal.z() < 0.0;
}

void paint(vtkPolyData* data, const Color& color, const Shading& shading, const Matt& matt) {
    vtkDataArray* normals = data->GetPointData()->GetNormals();
    vtkNew<vtkUnsignedCharArray> rgb;
    rgb->SetNumberOfComponents(3);
    rgb->SetNumberOfTuples(data->GetNumberOfPoints());
    for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id) {
        rgb->SetTypedTuple(id, shading.lit(color, Vector3(normals->GetTuple(id)), matt).data());
    }
    data->GetPointData()->SetScalars(rgb);
}

vtkSmartPointer<vtkActor> surfaceAsColored(vtkPolyData* data) {
    vtkSmartPointer<vtkActor> actor = plainSurface(data, kLightPalette.paper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetAmbient(0.0);
    actor->GetProperty()->SetDiffuse(1.0);
    actor->GetMapper()->ScalarVisibilityOn();
    actor->GetMapper()->SetColorModeToDirectScalars();
    double factor = 0.0;
    double units = 0.0;
    vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(factor, units);
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-factor, -units);
    return actor;
}

}  // namespace asperity
