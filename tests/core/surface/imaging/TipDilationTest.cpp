#include "core/Units.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace asperity {
namespace {

using test::kEpsilon;

/// One sphere lying on a plane, as seen from above.
struct LyingSphere {
    double radius = 0.0;  ///< [m]
    double x = 0.0;       ///< [m]
    double y = 0.0;       ///< [m]

    [[nodiscard]] double height(double px, double py) const {
        const double r = std::hypot(px - x, py - y);
        return r > radius ? 0.0 : radius + std::sqrt((radius - r) * (radius + r));
    }
    /// What a sphere of radius `tip` records of it. Source: docs/synthetic_surfaces.md 4.
    [[nodiscard]] double image(double px, double py, double tip) const {
        const double r = std::hypot(px - x, py - y);
        if (r > 2.0 * std::sqrt(radius * tip)) {
            return 0.0;
        }
        const double reach = radius + tip;
        return radius + std::sqrt((reach - r) * (reach + r)) - tip;
    }
};

struct Span {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
};

/// A sphere of 10 nm under a tip of 30 nm: recorded on the grid less the formula's image.
Span particleErrors(const ScanSize& size) {
    const LyingSphere sphere{.radius = 10.0_nm, .x = 50.3_nm, .y = 49.6_nm};
    const double tip = 30.0_nm;
    const HeightMap image = dilated(sampledMap(size, sphere), tip);
    Span errors;
    for (int row = 0; row < image.rows; ++row) {
        for (int column = 0; column < image.columns; ++column) {
            const double exact = sphere.image((column + 0.5) * image.pitchX,
                                              (image.rows - row - 0.5) * image.pitchY, tip);
            errors.lowest = std::min(errors.lowest, image.at(row, column) - exact);
            errors.highest = std::max(errors.highest, image.at(row, column) - exact);
        }
    }
    return errors;
}

/// The point of touch lies between pixels, at most half a diagonal from one; where the image meets
/// the plane the surface there is inclined by 60 degrees.
double subPixelBound(double halfDiagonal) {
    const double curvature = 1.0 / 10.0_nm + 1.0 / 30.0_nm;
    const double steepening = 8.0;  // 1 / cos^3 of the steepest position that is touched
    return 0.5 * halfDiagonal * halfDiagonal * curvature * steepening;
}

TEST(TipDilation, OfASphereIsTheSphereOfBothRadii) {
    const Span coarse = particleErrors({200, 200, 100.0_nm, 100.0_nm});
    const Span fine = particleErrors({400, 400, 100.0_nm, 100.0_nm});
    EXPECT_LE(coarse.highest, 8.0 * kEpsilon * 30.0_nm);
    EXPECT_GE(coarse.lowest, -subPixelBound(0.5 * std::sqrt(0.5) * 1.0_nm));
    EXPECT_LE(fine.highest, 8.0 * kEpsilon * 30.0_nm);
    EXPECT_GE(fine.lowest, -subPixelBound(0.25 * std::sqrt(0.5) * 1.0_nm));
    const double ratio = coarse.lowest / fine.lowest;
    EXPECT_GT(ratio, 3.0) << "the error falls with the square of the pitch";
    EXPECT_LT(ratio, 5.0);
    std::printf(
        "sphere 10 nm, tip 30 nm: at most %.3g nm low at 0.5 nm pitch, %.3g nm at 0.25 nm\n",
        -coarse.lowest * 1e9, -fine.lowest * 1e9);
}

TEST(TipDilation, OfASphereOnPixelsThatAreNotSquare) {
    const Span errors = particleErrors({400, 150, 100.0_nm, 100.0_nm});
    EXPECT_LE(errors.highest, 8.0 * kEpsilon * 30.0_nm);
    EXPECT_GE(errors.lowest, -subPixelBound(0.5 * std::hypot(0.25_nm, 100.0_nm / 150.0)));
}

}  // namespace
}  // namespace asperity
