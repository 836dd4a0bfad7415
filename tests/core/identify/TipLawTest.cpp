#include "core/identify/TipLaw.h"

#include "core/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace asperity {
namespace {

constexpr double kRadius = 1e-7;  // [m]
constexpr double kAngle = 0.6;    // [rad]

TipForm areaTip(const std::function<double(double)>& area) {
    TipForm tip{.kind = TipKind::Area};
    for (int i = 0; i <= 400; ++i) {
        const double height = 5e-10 * i;
        tip.area.push_back({height, area(height)});
    }
    return tip;
}

double tableError(const TipLaw& law, double indentation) {
    const IndentationPoint table = law.at(indentation);
    const IndentationPoint exact = law.exact(indentation);
    return std::max(std::abs(table.force / exact.force - 1.0),
                    std::abs(table.stiffness / exact.stiffness - 1.0));
}

TEST(TipLaw, TableAgreesWithTheLaw) {
    const TipForm sphere{.kind = TipKind::Sphere, .radius = 20e-6};
    const TipForm blunt{.kind = TipKind::ConeSphere, .radius = 10e-9, .angle = 0.35};
    for (const double share : {1e-4, 1e-2, 0.1, 0.5, 0.99, 1.5}) {
        EXPECT_LT(tableError(TipLaw(sphere, {}, 8e-6), share * 8e-6), 1e-7) << share;
        EXPECT_LT(tableError(TipLaw(blunt, {}, 1e-6), share * 1e-6), 1e-5) << share;
    }
}

TEST(TipLaw, SmallSphereContactIsThatOfTheParaboloid) {
    const TipLaw sphere({.kind = TipKind::Sphere, .radius = kRadius}, {}, 1e-7);
    const TipLaw paraboloid({.kind = TipKind::Paraboloid, .radius = kRadius}, {}, 1e-7);
    EXPECT_NEAR(sphere.at(1e-11).force / paraboloid.at(1e-11).force, 1.0, 1e-4);
    EXPECT_LT(sphere.at(5e-8).force, 0.99 * paraboloid.at(5e-8).force);
}

TEST(TipLaw, DeepConeSphereIsACone) {
    const TipLaw blunt({.kind = TipKind::ConeSphere, .radius = 1e-9, .angle = kAngle}, {}, 1e-5);
    const TipLaw cone({.kind = TipKind::Cone, .angle = kAngle}, {}, 1e-5);
    EXPECT_NEAR(blunt.at(1e-5).force / cone.at(1e-5).force, 1.0, 1e-3);
}

TEST(TipLaw, ContactRadiusOfAConeIsSneddons) {
    const TipLaw cone({.kind = TipKind::Cone, .angle = kAngle}, {}, 1e-7);
    EXPECT_NEAR(cone.exact(1e-7).contactRadius, 2.0 / std::numbers::pi * 1e-7 * std::tan(kAngle),
                1e-15);
}

TEST(TipLaw, PyramidsPressMoreThanTheConeOfTheirArea) {
    // An area of 4 h^2 tan^2 with four sides, of 3 sqrt(3) h^2 tan^2 with three.
    const auto coneOf = [](double areaFactor) {
        return 2.0 / std::numbers::pi * std::sqrt(areaFactor / std::numbers::pi) * 1e-14 *
               std::tan(kAngle);
    };
    const TipLaw four({.kind = TipKind::Pyramid4, .angle = kAngle}, {}, 1e-7);
    const TipLaw three({.kind = TipKind::Pyramid3, .angle = kAngle}, {}, 1e-7);
    EXPECT_NEAR(four.at(1e-7).force / coneOf(4.0), 1.04, 0.01);
    EXPECT_NEAR(three.at(1e-7).force / coneOf(3.0 * std::sqrt(3.0)), 1.08, 0.01);
}

TEST(TipLaw, AreaFunctionOfAParaboloidIsHertz) {
    const TipForm tip = areaTip([](double h) { return 2.0 * std::numbers::pi * kRadius * h; });
    const TipLaw area(tip, {}, 1e-7);
    const TipLaw hertz({.kind = TipKind::Paraboloid, .radius = kRadius}, {}, 1e-7);
    for (const double depth : {1e-9, 1e-8, 1e-7, 3e-7}) {
        EXPECT_NEAR(area.exact(depth).force / hertz.at(depth).force, 1.0, 1e-12) << depth;
        EXPECT_NEAR(area.exact(depth).stiffness / hertz.at(depth).stiffness, 1.0, 1e-12) << depth;
    }
}

TEST(TipLaw, AreaFunctionOfAConeIsSneddons) {
    const TipForm tip = areaTip(
        [](double h) { return std::numbers::pi * h * h * std::tan(kAngle) * std::tan(kAngle); });
    const TipLaw area(tip, {}, 1e-7);
    const TipLaw cone({.kind = TipKind::Cone, .angle = kAngle}, {}, 1e-7);
    EXPECT_NEAR(area.at(5e-8).force / cone.at(5e-8).force, 1.0, 1e-3);
    EXPECT_NEAR(area.at(1e-7).force / cone.at(1e-7).force, 1.0, 1e-4);
}

TEST(TipLaw, ThickFilmIsAHalfSpaceAndAThinOneIsStiffer) {
    const TipForm tip{.kind = TipKind::Paraboloid, .radius = 5e-6};
    const TipLaw half(tip, {}, 1e-6);
    const TipLaw thick(tip, {.thickness = 1e-3}, 1e-6);
    const TipLaw thin(tip, {.thickness = 1e-6}, 1e-6);
    EXPECT_NEAR(thick.at(1e-6).force / half.at(1e-6).force, 1.0, 0.01);
    EXPECT_GT(thin.at(1e-6).force, 3.0 * half.at(1e-6).force);
}

TEST(TipLaw, RefusesWhatNoTipIs) {
    EXPECT_THROW(TipLaw({.kind = TipKind::Sphere, .radius = 2.0}, {}, 1e-6), Error);
    EXPECT_THROW(TipLaw({.kind = TipKind::Cone, .angle = 1.57}, {}, 1e-6), Error);
    EXPECT_THROW(TipLaw({.kind = TipKind::Area}, {}, 1e-6), Error);
    EXPECT_THROW(TipLaw({.kind = TipKind::Cone, .angle = 0.3}, {.thickness = 1e-6}, 1e-6), Error);
}

}  // namespace
}  // namespace asperity
