#include "core/surface/nurbs/NurbsSurface.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/nurbs/NurbsShapes.h"
#include "tests/core/surface/nurbs/TiltedFrame.h"
#include "tests/core/surface/nurbs/UnevenNet.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace asperity {
namespace {

using test::kFrame;
using test::kNan;
using test::kRadius;

/// With uneven weights, too.
NurbsSurface::Net unevenNet() {
    return test::unevenNet([](int i, int j) {
        return test::WeightedPoint{Vector3(i + 0.2 * std::sin(3.0 * j), j + 0.1 * std::cos(2.0 * i),
                                           std::sin(1.7 * i + j * j)),
                                   1.0 + 0.5 * std::sin(i + 2.0 * j)};
    });
}

/// The B-spline basis by its definition, the recursion of Cox and de Boor.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double t) {
    if (degree == 0) {
        return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
    }
    const auto d = static_cast<std::size_t>(degree);
    const double left = knots[i + d] - knots[i];
    const double right = knots[i + d + 1] - knots[i + 1];
    return (left > 0.0 ? (t - knots[i]) / left * basis(knots, i, degree - 1, t) : 0.0) +
           (right > 0.0 ? (knots[i + d + 1] - t) / right * basis(knots, i + 1, degree - 1, t)
                        : 0.0);
}

Vector3 pointByDefinition(const NurbsSurface::Net& net, double u, double v) {
    const std::size_t columns = net.knotsU.size() - static_cast<std::size_t>(net.degreeU) - 1;
    Vector3 sum = Vector3::Zero();
    double weights = 0.0;
    for (std::size_t k = 0; k < net.points.size(); ++k) {
        const double share = net.weights[k] * basis(net.knotsU, k % columns, net.degreeU, u) *
                             basis(net.knotsV, k / columns, net.degreeV, v);
        sum += share * net.points[k];
        weights += share;
    }
    return sum / weights;
}

TEST(NurbsSurface, IsTheSumOfItsBasisFunctions) {
    const NurbsSurface::Net net = unevenNet();
    const NurbsSurface surface(net);
    for (int i = 0; i < 37; ++i) {
        for (int j = 0; j < 29; ++j) {
            const double u = (i + 0.5) / 37;
            const double v = (j + 0.5) / 29;
            const Vector3 expected = pointByDefinition(net, u, std::lerp(1.0, 4.0, v));
            ASSERT_LT((surface.at(u, v).point - expected).norm(), 1e-14);
        }
    }
}

TEST(NurbsSurface, HasTheDerivativesOfItsPoints) {
    const NurbsSurface surface(unevenNet());
    constexpr double kStep = 1e-4;
    const auto fourth = [&](auto&& f) {  // error of the fourth order of the step
        return ((8.0 * (f(kStep) - f(-kStep)) - (f(2.0 * kStep) - f(-2.0 * kStep))) /
                (12.0 * kStep))
            .eval();
    };
    for (const double u : {0.05, 0.21, 0.44, 0.77, 0.93}) {
        for (const double v : {0.1, 0.4, 0.61, 0.87}) {
            const ParametricSample s = surface.at(u, v);
            const auto expectSame = [](const Vector3& a, const Vector3& b) {
                EXPECT_LT((a - b).norm(), 1e-8 * (1.0 + b.norm()));
            };
            expectSame(s.du, fourth([&](double d) { return surface.at(u + d, v).point; }));
            expectSame(s.dv, fourth([&](double d) { return surface.at(u, v + d).point; }));
            expectSame(s.duu, fourth([&](double d) { return surface.at(u + d, v).du; }));
            expectSame(s.duv, fourth([&](double d) { return surface.at(u, v + d).du; }));
            expectSame(s.dvv, fourth([&](double d) { return surface.at(u, v + d).dv; }));
        }
    }
}

TEST(NurbsSurface, OfASphereLiesOnTheSphere) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    for (int i = 0; i <= 40; ++i) {
        for (int j = 0; j <= 40; ++j) {
            const double u = i / 40.0;
            const double v = j / 40.0;
            const Vector3 arm = sphere.at(u, v).point - kFrame.center;
            ASSERT_NEAR(arm.norm(), kRadius, 1e-15 * 1e3 * kRadius);
            ASSERT_LT((sphere.normal(u, v) - arm / kRadius).norm(), 1e-10) << u << ' ' << v;
        }
    }
}

TEST(NurbsSurface, OfASphereIsCurvedByOneOverItsRadiusEverywhere) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    for (const double u : {0.0, 0.11, 0.5, 0.83, 1.0}) {
        for (const double v : {0.0, 1e-12, 1e-4, 1e-2, 0.3, 0.5, 0.9, 1.0 - 1e-9, 1.0}) {
            const PrincipalCurvatures bend = sphere.curvatures(u, v);
            EXPECT_NEAR(bend.largest * kRadius, 1.0, 1e-8) << u << ' ' << v;
            EXPECT_NEAR(bend.smallest * kRadius, 1.0, 1e-8) << u << ' ' << v;
        }
    }
    const PrincipalCurvatures bend = sphere.curvatures(0.3, 0.4);
    EXPECT_NEAR(bend.largest * kRadius, 1.0, 1e-12);
    EXPECT_NEAR(bend.smallest * kRadius, 1.0, 1e-12);
}

TEST(NurbsSurface, OfACylinderIsCurvedAroundItAlone) {
    const NurbsSurface cylinder = cylinderSurface(kFrame, kRadius, kRadius);
    const PrincipalCurvatures bend = cylinder.curvatures(0.37, 0.2);
    EXPECT_NEAR(bend.largest * kRadius, 1.0, 1e-12);
    EXPECT_NEAR(bend.smallest * kRadius, 0.0, 1e-12);
}

/// A torus is a saddle inside: -1/(R - r) along the ring, 1/r around the tube.
TEST(NurbsSurface, OfATorusIsASaddleInside) {
    const double tube = 60.0_nm;
    const NurbsSurface torus = torusSurface(kFrame, kRadius, tube);
    const PrincipalCurvatures outside = torus.curvatures(0.2, 0.0);
    EXPECT_NEAR(outside.largest * tube, 1.0, 1e-12);
    EXPECT_NEAR(outside.smallest * (kRadius + tube), 1.0, 1e-12);
    const PrincipalCurvatures inside = torus.curvatures(0.2, 0.5);
    EXPECT_NEAR(inside.largest * tube, 1.0, 1e-12);
    EXPECT_NEAR(inside.smallest * (kRadius - tube), -1.0, 1e-12);
}

TEST(NurbsSurface, KnowsItsSeamsAndPoles) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    EXPECT_EQ(sphere.closed(), (std::array{true, false}));
    EXPECT_EQ(sphere.collapsed(), (std::array{false, false, true, true}));
    EXPECT_EQ(torusSurface(kFrame, kRadius, 50.0_nm).closed(), (std::array{true, true}));
    const NurbsSurface uneven(unevenNet());
    EXPECT_EQ(uneven.closed(), (std::array{false, false}));
    EXPECT_EQ(uneven.collapsed(), (std::array{false, false, false, false}));
}

TEST(NurbsSurface, LiesInItsBoxes) {
    const NurbsSurface surface(unevenNet());
    for (int i = 0; i <= 30; ++i) {
        for (int j = 0; j <= 30; ++j) {
            EXPECT_NEAR(surface.bounds().squaredDistance(surface.at(i / 30.0, j / 30.0).point), 0.0,
                        1e-28);
        }
    }
    EXPECT_EQ(surface.boxes().size(), 2 * surface.patches().size() - 1);
}

std::string refusalOf(const std::function<void(NurbsSurface::Net&)>& spoil) {
    NurbsSurface::Net net = unevenNet();
    spoil(net);
    try {
        const NurbsSurface surface(net);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(NurbsSurface, RefusesWhatIsNoSurfaceInOneSentence) {
    using Net = NurbsSurface::Net;
    EXPECT_EQ(refusalOf([](Net&) {}), "");
    EXPECT_EQ(refusalOf([](Net& net) { net.degreeU = 0; }),
              "a NURBS surface must have a degree from 1 to 5 along u");
    EXPECT_EQ(refusalOf([](Net& net) { net.degreeV = 6; }),
              "a NURBS surface must have a degree from 1 to 5 along v");
    EXPECT_EQ(refusalOf([](Net& net) { net.knotsU.resize(6); }),
              "a NURBS surface must have knots along u that are at least twice the degree and two");
    EXPECT_EQ(refusalOf([](Net& net) { net.knotsV[3] = 0.5; }),
              "a NURBS surface must have knots along v that never fall");
    EXPECT_EQ(refusalOf([](Net& net) { net.knotsV[3] = kNan; }),
              "a NURBS surface must have knots along v that are finite numbers");
    EXPECT_EQ(refusalOf([](Net& net) { net.knotsV.assign(8, 1.0); }),
              "a NURBS surface must have knots along v that span a length");
    EXPECT_EQ(refusalOf([](Net& net) { net.points.pop_back(); }),
              "a NURBS surface must have 35 control points for its knots, not 34");
    EXPECT_EQ(refusalOf([](Net& net) { net.weights.pop_back(); }),
              "a NURBS surface must have one weight a control point, or none");
    EXPECT_EQ(refusalOf([](Net& net) { net.points[7].y() = kNan; }),
              "a NURBS surface must have control points within 1e9 m of the origin");
    EXPECT_EQ(refusalOf([](Net& net) { net.weights[7] = 0.0; }),
              "a NURBS surface must have weights that are positive numbers");
    EXPECT_EQ(refusalOf([](Net& net) { net.weights[7] = 1e7; }),
              "a NURBS surface must have weights within a factor of a million of each other");
}

TEST(NurbsSurface, RefusesToBeTornApartOrToHaveNoSize) {
    NurbsSurface::Net net = unevenNet();
    net.knotsV = {0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0};
    net.points.resize(42, Vector3::Zero());
    net.weights.resize(42, 1.0);
    EXPECT_THROW(NurbsSurface{net}, Error);
    EXPECT_THROW(sphereSurface(kFrame, 0.0), Error);
    EXPECT_THROW(cylinderSurface(kFrame, kRadius, -1.0), Error);
    EXPECT_THROW(torusSurface(kFrame, kRadius, kRadius), Error);
    EXPECT_THROW(planeSurface(Vector3::Zero(), Vector3::UnitX(), Vector3::UnitX()), Error);
}

}  // namespace
}  // namespace asperity
