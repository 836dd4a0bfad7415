#include "core/Units.h"
#include "core/contact/ContactState.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/probe/BodySum.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/sample/SampleSurface.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace asperity {
namespace {

constexpr double kBluntRadius = 2.0_um;
constexpr double kBumpPitch = 4.0_nm;
constexpr int kBumpSide = 257;
constexpr double kBumpMiddle = 0.5 * kBumpSide * kBumpPitch;

BSplineSurface bumpSurface(const std::function<double(double, double)>& height) {
    HeightMap map{
        .columns = kBumpSide, .rows = kBumpSide, .pitchX = kBumpPitch, .pitchY = kBumpPitch};
    for (int row = 0; row < kBumpSide; ++row) {
        for (int column = 0; column < kBumpSide; ++column) {
            map.heights.push_back(
                height((column - kBumpSide / 2) * kBumpPitch, (kBumpSide / 2 - row) * kBumpPitch));
        }
    }
    return fitSurface(std::move(map));
}

/// An asperity of 40 nm radius at its top.
double bumpHeight(double x, double y, double height) {
    return height * std::exp(-(x * x + y * y) / (2.0 * 40.0_nm * height));
}

/// Oxide under silicon.
ProbeSystem bluntSystem() {
    return {.contact = {ContactLaw::Split, {kBluntRadius, 53.4_GPa, 0.2}},
            .cantilever = Cantilever(test::plainScene().probe),
            .friction = {}};
}

/// A tip that touches the middle, so deep. @param indentation [m]
TipState touchingMiddle(const BSplineSurface& surface, double indentation) {
    const double top = surface.at(kBumpMiddle, kBumpMiddle).height;
    TipState state;
    state.closest = SampleSurface(surface).localContactPoint(
        {kBumpMiddle, kBumpMiddle, top + kBluntRadius}, {kBumpMiddle, kBumpMiddle, true});
    const PrincipalCurvatures& bend = state.closest.curvatures;
    state.effectiveRadius = effectiveRadius(kBluntRadius, bend.largest, bend.smallest).radius;
    state.contact.indentation = indentation;
    return state;
}

double besideMiddle(const BSplineSurface& surface, double indentation) {
    return bodyAttraction(surface, bluntSystem(), touchingMiddle(surface, indentation)).force;
}

/// Pull of a sphere and a half-space at a separation [N].
double pullOfPlane(double separation) {
    return hamakerConstant(0.2) * kBluntRadius / (6.0 * separation * separation);
}

TEST(BodyAttraction, PlanesHaveNothingBesideTheContact) {
    const BSplineSurface flat = bumpSurface([](double, double) { return 0.0; });
    const BSplineSurface slope = bumpSurface([](double x, double y) { return 0.2 * x - 0.1 * y; });
    for (const double indentation : {-100.0_nm, -1.0_nm, 0.0, 1.0_nm}) {
        EXPECT_EQ(besideMiddle(flat, indentation), 0.0);
        EXPECT_NEAR(besideMiddle(slope, indentation), 0.0, 1e-4 * pullOfPlane(0.5_nm));
    }
}

TEST(BodyAttraction, NorHasASampleThatIsItsOwnParaboloid) {
    const BSplineSurface bowl = bumpSurface(
        [](double x, double y) { return (x * y - 2.0 * x * x - y * y) / (2.0 * 500.0_nm); });
    for (const double indentation : {-10.0_nm, 0.0, 1.0_nm}) {
        EXPECT_NEAR(besideMiddle(bowl, indentation), 0.0, 1e-3 * pullOfPlane(0.5_nm));
    }
}

TEST(BodyAttraction, UnderANarrowAsperityItIsThatOfSphereAndHalfSpace) {
    for (const double height : {8.0_nm, 20.0_nm, 40.0_nm}) {
        const BSplineSurface needle = bumpSurface([&](double x, double y) {
            return height * std::exp(-(x * x + y * y) / (2.0 * 8.0_nm * 8.0_nm));
        });
        const TipState state = touchingMiddle(needle, 0.0);
        const double separation = kContactSeparation + state.closest.point.z();
        // The flanks are no paraboloid: a part of what the law counts of the needle itself.
        const double ofNeedle =
            0.25 * hamakerConstant(0.2) * state.effectiveRadius / (6.0 * 0.5_nm * 0.5_nm);
        EXPECT_NEAR(-besideMiddle(needle, 0.0), pullOfPlane(separation),
                    0.05 * pullOfPlane(separation) + ofNeedle)
            << height;
    }
}

/// The same integral along one radius of the bump's formula.
double besideBump(double height, double curvature, double indentation) {
    constexpr int kSteps = 200'000;
    const double cohesive = std::pow(kContactSeparation + kCohesiveRange, 3);
    const double touch = kContactSeparation - indentation;
    const auto traction = [&](double gap) {
        const double cube = std::pow(std::max(touch + gap, 0.0), 3);
        return cube / std::pow(cube + cohesive, 2);
    };
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {  // denser near the middle
        const double share = (i + 0.5) / kSteps;
        const double r = kBluntRadius * share * share;
        const double cap = r * r / (kBluntRadius + std::sqrt(kBluntRadius * kBluntRadius - r * r));
        const double below = height - bumpHeight(r, 0.0, height);
        sum += (traction(cap + below) - traction(cap + 0.5 * curvature * r * r)) * r * 2.0 *
               kBluntRadius * share / kSteps;
    }
    return -hamakerConstant(0.2) / 3.0 * sum;
}

TEST(BodyAttraction, AgreesWithAQuadratureOverTheFormulaOfABump) {
    for (const double height : {3.0_nm, 8.0_nm, 24.0_nm}) {
        const BSplineSurface surface =
            bumpSurface([&](double x, double y) { return bumpHeight(x, y, height); });
        for (const double indentation : {-20.0_nm, -2.0_nm, 0.0, 0.2_nm}) {
            const TipState state = touchingMiddle(surface, indentation);
            const double exact = besideBump(height, state.closest.curvatures.largest, indentation);
            const BodyAttraction found = bodyAttraction(surface, bluntSystem(), state);
            EXPECT_NEAR(found.force, exact, 0.02 * std::abs(exact)) << height << ' ' << indentation;
            EXPECT_NEAR(found.share * 1.5 * std::numbers::pi * 0.2 * state.effectiveRadius,
                        found.force, 1e-12 * std::abs(found.force));
        }
    }
}

TEST(BodyAttraction, ANarrowPlateauHasLessBesideItThanTheLawCounts) {
    const BSplineSurface plateau = bumpSurface([](double x, double y) {
        return 20.0_nm / (1.0 + std::pow((x * x + y * y) / (60.0_nm * 60.0_nm), 4));
    });
    EXPECT_GT(besideMiddle(plateau, 0.0), 0.0);
}

TEST(BodyAttraction, WithoutAdhesionThereIsNone) {
    const BSplineSurface surface =
        bumpSurface([](double x, double y) { return bumpHeight(x, y, 8.0_nm); });
    ProbeSystem system = bluntSystem();
    system.contact = ContactModel(ContactLaw::Hertz, {kBluntRadius, 53.4_GPa, 0.0});
    EXPECT_EQ(bodyAttraction(surface, system, touchingMiddle(surface, 0.0)).force, 0.0);
}

}  // namespace
}  // namespace asperity
