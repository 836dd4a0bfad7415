#include "tests/vtkplugins/Fakes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace asperity::test {

namespace {

constexpr double kTipRadius = 15.0_nm;
constexpr double kHalfWidth = 20.0_nm;
const Vector3 kCenter(500.0_nm, 400.0_nm, 5.0_nm);

/// Displacement of a JKR contact, positive into the sample; punch depth 0: Hertz. Source:
/// Johnson, Contact Mechanics (1985), 3.4 and 5.5.
double displacement(double r, double contactRadius, double punchDepth) {
    const double a = contactRadius;
    if (r <= a) {
        return (a * a - 0.5 * r * r) / kTipRadius - punchDepth;
    }
    const double ratio = r / a;
    const double angle = std::asin(1.0 / ratio);
    const double hertz = a * a / (std::numbers::pi * kTipRadius) *
                         (std::sqrt(ratio * ratio - 1.0) + (2.0 - ratio * ratio) * angle);
    return hertz - 2.0 / std::numbers::pi * punchDepth * angle;
}

Vector3 normalAt(const SurfacePatch& patch, int row, int column) {
    const auto point = [&patch](int r, int c) {
        return patch.points[patch.index(std::clamp(r, 0, patch.rows - 1),
                                        std::clamp(c, 0, patch.columns - 1))];
    };
    const Vector3 alongX = (point(row, column + 1) - point(row, column - 1)).normalized();
    const Vector3 alongY = (point(row + 1, column) - point(row - 1, column)).normalized();
    return alongX.cross(alongY).normalized();
}

SurfacePatch patchOf(double contactRadius, double punchDepth) {
    SurfacePatch patch;
    patch.columns = 121;
    patch.rows = 121;
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const double x = kHalfWidth * (column / 60.0 - 1.0);
            const double y = kHalfWidth * (row / 60.0 - 1.0);
            const double depth = displacement(std::hypot(x, y), contactRadius, punchDepth);
            patch.rest.emplace_back(kCenter + Vector3(x, y, 0.0));
            patch.points.emplace_back(kCenter + Vector3(x, y, -depth));
        }
    }
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            patch.normals.push_back(normalAt(patch, row, column));
        }
    }
    return patch;
}

DeformationView viewOf(double contactRadius, double punchDepth) {
    DeformationView view;
    view.patch = patchOf(contactRadius, punchDepth);
    view.tipRadius = kTipRadius;
    view.contactRadius = contactRadius;
    view.contactPoint = kCenter - Vector3(0.0, 0.0, displacement(0.0, contactRadius, punchDepth));
    view.tipCenter = view.contactPoint + Vector3(0.0, 0.0, kTipRadius);
    return view;
}

}  // namespace

BSplineSurface eggBox() {
    constexpr double kPeriod = 250.0_nm;
    const double wave = 2.0 * std::numbers::pi / kPeriod;
    return splineOf(256, 1000.0_nm / 256, [wave](double x, double y) {
        return 20.0_nm * std::cos(wave * x) * std::cos(wave * y);
    });
}

DeformationView hertzDent() {
    DeformationView view = viewOf(3.0_nm, 0.0);
    view.title = "Maximum indentation, t = 0.482 s";
    view.caption = "Indentation 0.600 nm, contact radius 3.00 nm, normal force 185 nN. "
                   "Silicon tip on mica, work of adhesion 80 mJ/m², Maugis parameter 0.41.";
    view.force = Vector3(12.0_nN, 4.0_nN, 185.0_nN);
    return view;
}

DeformationView adhesionNeck() {
    DeformationView view = viewOf(2.0_nm, 0.6_nm);
    view.title = "Just before pull-off, t = 0.913 s";
    view.caption = "Indentation -0.333 nm, contact radius 2.00 nm, adhesive force 42 nN.";
    view.force = Vector3(0.0, 0.0, -42.0_nN);
    return view;
}

}  // namespace asperity::test
