#include "core/surface/Curvature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

/// Height and derivatives of the upper half of a sphere of radius 1 at (x, y).
HeightSample sphereAt(double x, double y) {
    const double z = std::sqrt(1.0 - x * x - y * y);
    const double cube = z * z * z;
    return {z, -x / z, -y / z, -(z * z + x * x) / cube, -x * y / cube, -(z * z + y * y) / cube};
}

TEST(PrincipalCurvatures, OfASphereAreOneOverItsRadiusEverywhere) {
    for (const double x : {0.0, 0.3, -0.7}) {
        for (const double y : {0.0, 0.2, 0.6}) {
            const PrincipalCurvatures found = principalCurvatures(sphereAt(x, y));
            EXPECT_NEAR(found.largest, 1.0, 1e-7) << x << ' ' << y;  // a double root: sqrt(epsilon)
            EXPECT_NEAR(found.smallest, 1.0, 1e-7) << x << ' ' << y;
        }
    }
}

TEST(PrincipalCurvatures, OfACylinderAreOneOverItsRadiusAndZero) {
    const double x = 0.5;  // z = sqrt(1 - x^2): along y it is straight
    const double z = std::sqrt(1.0 - x * x);
    const PrincipalCurvatures ridge =
        principalCurvatures({z, -x / z, 0.0, -1.0 / (z * z * z), 0.0, 0.0});
    EXPECT_NEAR(ridge.largest, 1.0, 1e-14);
    EXPECT_NEAR(ridge.smallest, 0.0, 1e-14);
    const PrincipalCurvatures valley =
        principalCurvatures({-z, x / z, 0.0, 1.0 / (z * z * z), 0.0, 0.0});
    EXPECT_NEAR(valley.smallest, -1.0, 1e-14) << "a valley is negative";
}

}  // namespace
}  // namespace asperity
