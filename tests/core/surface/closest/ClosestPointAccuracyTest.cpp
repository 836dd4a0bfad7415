#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/StorageError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

namespace asperity {
namespace {

constexpr double kSize = 200.0_nm;
constexpr double kHalfSize = 0.5 * kSize;

/// z = sqrt(R^2 - distance^2 from an axis or a center) about the scan's middle; from 0.8 R on, far
/// from all closest points, straight down the tangent there (whose derivatives nobody asks for).
HeightSample roundAt(double radius, const Eigen::Matrix2d& across, const Vector2& position) {
    const Vector2 offset = across * (position - Vector2::Constant(kHalfSize));
    const double beyond = offset.norm() - 0.8 * radius;
    if (beyond > 0.0) {
        return {.height = 0.6 * radius - 0.8 / 0.6 * beyond};
    }
    const double height = std::sqrt(radius * radius - offset.squaredNorm());
    const Vector2 slope = -offset / height;
    const Eigen::Matrix2d bend = -(across + slope * slope.transpose()) / height;
    return {.height = height,
            .dx = slope.x(),
            .dy = slope.y(),
            .dxx = bend(0, 0),
            .dxy = bend(0, 1),
            .dyy = bend(1, 1)};
}

HeightSample eggBoxAt(const Vector2& position) {
    return EggBox{.amplitude = 5.0_nm, .periodX = 90.0_nm, .periodY = 70.0_nm}.at(position.x(),
                                                                                  position.y());
}
HeightSample sphereAt(const Vector2& position) {
    return roundAt(60.0_nm, Eigen::Matrix2d::Identity(), position);
}
/// Its axis is turned by 30 degrees from x.
HeightSample cylinderAt(const Vector2& position) {
    const Vector2 normal(-0.5, std::sqrt(0.75));
    return roundAt(60.0_nm, normal * normal.transpose(), position);
}
HeightSample steepPlaneAt(const Vector2& position) {
    const double slope = std::tan(80.0 * M_PI / 180.0);
    const Vector2 offset = position - Vector2::Constant(kHalfSize);
    return {.height = slope * (0.8 * offset.x() + 0.6 * offset.y()),
            .dx = 0.8 * slope,
            .dy = 0.6 * slope};
}

struct Analytic {
    std::string name;
    HeightSample (*at)(const Vector2& position);

    [[nodiscard]] double height(double x, double y) const { return at({x, y}).height; }
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Analytic& shape, std::ostream* out) { *out << shape.name; }

/// Largest errors of closest points whose true positions are known.
struct Errors {
    double position = 0.0;   ///< along the normal [m]
    double normal = 0.0;     ///< also moves the closest point along the surface [rad]
    double curvature = 0.0;  ///< [1/m]
};

class ClosestPointAccuracyOn : public testing::TestWithParam<Analytic> {
protected:
    static constexpr double kDistance = 15.0_nm;

    [[nodiscard]] static BSplineSurface sampledBy(int pixels) {
        return fitSurface(sampledMap(
            {.columns = pixels, .rows = pixels, .sizeX = kSize, .sizeY = kSize}, GetParam()));
    }
    /// Off the scan's borders, where a spline fits less well.
    static Errors errorsOf(const BSplineSurface& surface) {
        Errors errors;
        Random random(12);
        for (int i = 0; i < 400; ++i) {
            const Vector2 position(kSize * random.uniform(0.4, 0.6),
                                   kSize * random.uniform(0.4, 0.6));
            const HeightSample truth = GetParam().at(position);
            const Vector3 point(position.x(), position.y(), truth.height);
            const ClosestPoint closest =
                closestPoint(surface, point + kDistance * truth.normal(), {});
            EXPECT_TRUE(closest.certified());
            const PrincipalCurvatures curvatures = principalCurvatures(truth);
            errors.position = std::max(errors.position, std::abs(closest.distance - kDistance));
            errors.normal = std::max(errors.normal, (closest.normal - truth.normal()).norm());
            errors.curvature = std::max(
                {errors.curvature, std::abs(closest.curvatures.largest - curvatures.largest),
                 std::abs(closest.curvatures.smallest - curvatures.smallest)});
        }
        return errors;
    }
};

/// An error of order p falls by 2^p when the pitch is halved, until rounding is all that is left.
/// Source: de Boor, A Practical Guide to Splines (1978): cubic interpolation has order 4, and each
/// derivative one less.
TEST_P(ClosestPointAccuracyOn, FallsWithThePowersOfThePitch) {
    constexpr double kNearly = 0.85;  // of the order: the largest of random positions
    Errors coarse = errorsOf(sampledBy(30));
    for (const int pixels : {60, 120}) {
        const BSplineSurface surface = sampledBy(pixels);
        const test::StorageError storage = test::storageErrorOf(surface);
        const Errors fine = errorsOf(surface);
        EXPECT_LE(fine.position, coarse.position * std::exp2(-4.0 * kNearly) + storage.height);
        EXPECT_LE(fine.normal, coarse.normal * std::exp2(-3.0 * kNearly) + 2.0 * storage.slope);
        EXPECT_LE(fine.curvature,
                  coarse.curvature * std::exp2(-2.0 * kNearly) + 2.0 * storage.curvature);
        coarse = fine;
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosestPointAccuracyOn,
                         testing::Values(Analytic{"EggBox", eggBoxAt},
                                         Analytic{"SphereCap", sphereAt},
                                         Analytic{"Cylinder", cylinderAt},
                                         Analytic{"PlaneAt80Degrees", steepPlaneAt}),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
