#include "core/probe/BodySum.h"

#include "core/Units.h"
#include "core/contact/ContactState.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/HeightMoments.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/sample/SampleSurface.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace asperity {
namespace {

constexpr double kTipRadius = 2.0_um;
constexpr double kPitch = 4.0_nm;
constexpr int kSide = 257;
constexpr double kMiddle = 0.5 * kSide * kPitch;
constexpr double kWork = 0.2;  // [J/m^2], oxide under silicon

/// Heights as a function of the distances from the middle.
using Heights = std::function<double(double, double)>;

std::shared_ptr<const HeightMoments> momentsOf(const Heights& height) {
    HeightMap map{.columns = kSide, .rows = kSide, .pitchX = kPitch, .pitchY = kPitch};
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            map.heights.push_back(
                height((column - kSide / 2) * kPitch, (kSide / 2 - row) * kPitch));
        }
    }
    return std::make_shared<HeightMoments>(fitSurface(std::move(map)));
}

/// An asperity of 40 nm radius at its top.
double asperity(double x, double y, double height) {
    return height * std::exp(-(x * x + y * y) / (2.0 * 40.0_nm * height));
}

ProbeSystem systemOn(std::shared_ptr<const HeightMoments> beside, double stiffness = 14.0) {
    CantileverGeometry lever = test::plainScene().probe;
    lever.thickness = thicknessForStiffness(lever, stiffness);
    return {.contact = {ContactLaw::Split, {kTipRadius, 53.4_GPa, kWork}},
            .cantilever = Cantilever(lever),
            .friction = {},
            .beside = std::move(beside)};
}

/// A tip that comes down at a distance from the middle and touches, or is deeper.
TipState touching(const HeightMoments& sample, double x = 0.0, double y = 0.0,
                  double indentation = 0.0) {
    const SampleSurface surface(sample.surface());
    ClosestPointTracker tracker;
    TipState state;
    state.tip = {kMiddle + x, kMiddle + y, sample.surface().bounds().all().highest};
    for (int i = 0; i < 60; ++i) {
        const Vector3 center = state.tip + Vector3(0.0, 0.0, kTipRadius);
        state.closest =
            *surface.contactPoints({center, kTipRadius}, 0.0, {}, tracker).list.all().begin();
        state.tip.z() -= state.closest.distance - kTipRadius + indentation;
    }
    const PrincipalCurvatures& bend = state.closest.curvatures;
    state.effectiveRadius = effectiveRadius(kTipRadius, bend.largest, bend.smallest).radius;
    state.contact.indentation = indentation;
    return state;
}

BodyForce forceOn(const HeightMoments& sample, const TipState& state) {
    const ProbeSystem system = systemOn(nullptr);
    ContactPair pair = system.contact.pair();
    pair.tipRadius = state.effectiveRadius;
    return bodyForce(sample, bodyTraction(system, pair), state.tip, {&state.closest.point, 1},
                     state.closest.normal);
}

double pullOff(const TipState& state) {
    return 1.5 * std::numbers::pi * kWork * state.effectiveRadius;
}

/// Pull of a sphere and a half-space at a separation [N].
double pullOfHalfSpace(double separation) {
    return hamakerConstant(kWork) * kTipRadius / (6.0 * separation * separation);
}

TEST(BodySum, APlaneHasNothingBesideTheContactWhateverItsSlope) {
    for (const double slope : {0.0, 0.03, 0.08}) {  // the scan's edges far beyond the contact
        const auto plane = momentsOf([&](double x, double y) { return slope * (x - 0.5 * y); });
        for (const double indentation : {-2.0_nm, 0.0, 1.0_nm}) {
            const BodyForce found = forceOn(*plane, touching(*plane, 0.0, 0.0, indentation));
            EXPECT_NEAR(found.force, 0.0, 2e-3 * pullOfHalfSpace(0.5_nm))
                << slope << ' ' << indentation;
        }
    }
}

TEST(BodySum, NorHasASampleThatIsItsOwnParaboloid) {
    const auto bowl = momentsOf(
        [](double x, double y) { return (x * y - 2.0 * x * x - y * y) / (2.0 * 500.0_nm); });
    for (const double indentation : {-10.0_nm, 0.0, 1.0_nm}) {
        EXPECT_NEAR(forceOn(*bowl, touching(*bowl, 0.0, 0.0, indentation)).force, 0.0,
                    1e-3 * pullOfHalfSpace(0.5_nm));
    }
}

TEST(BodySum, UnderANarrowAsperityItIsThatOfSphereAndHalfSpace) {
    for (const double height : {8.0_nm, 20.0_nm, 40.0_nm}) {
        const auto needle = momentsOf([&](double x, double y) {
            return height * std::exp(-(x * x + y * y) / (2.0 * 8.0_nm * 8.0_nm));
        });
        const TipState state = touching(*needle);
        const double plane = pullOfHalfSpace(kContactSeparation + state.closest.point.z());
        // The flanks are no paraboloid: a part of what the law counts of the needle itself.
        const double own =
            0.25 * hamakerConstant(kWork) * state.effectiveRadius / (6.0 * 0.5_nm * 0.5_nm);
        EXPECT_NEAR(-forceOn(*needle, state).force, plane, 0.05 * plane + own) << height;
    }
}

/// Two independent sums of one formula: along z over squares of the scan, and along the normal over
/// rings of look-ups.
TEST(BodySum, AgreesWithTheDenseSumOverABump) {
    for (const double height : {3.0_nm, 8.0_nm, 24.0_nm}) {
        const auto bump = momentsOf([&](double x, double y) { return asperity(x, y, height); });
        for (const double indentation : {-20.0_nm, -2.0_nm, 0.0, 0.2_nm}) {
            const TipState state = touching(*bump, 0.0, 0.0, indentation);
            const double dense = bodyAttraction(bump->surface(), systemOn(nullptr), state).force;
            EXPECT_NEAR(forceOn(*bump, state).force, dense,
                        0.05 * std::abs(dense) + 2e-3 * pullOff(state))
                << height << ' ' << indentation;
        }
    }
}

/// A film of bumps at random positions, turned by an angle around the middle.
double filmHeight(double x, double y, double angle) {
    const double u = x * std::cos(angle) - y * std::sin(angle);
    const double v = x * std::sin(angle) + y * std::cos(angle);
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
        const auto share = [i](double irrational) {  // evenly spread, not on a lattice
            const double product = (i + 1) * irrational;
            return product - std::floor(product);
        };
        const double width = 12.0_nm + 20.0_nm * share(0.4142135623730951);
        const double away = std::hypot(u - 800.0_nm * (share(0.7548776662466927) - 0.5),
                                       v - 800.0_nm * (share(0.5698402909980532) - 0.5));
        sum += (2.0_nm + 7.0_nm * share(0.2360679774997898)) *
               std::exp(-0.5 * away * away / (width * width));
    }
    return sum;
}

/// A rough film has no direction that a sum may prefer: six a ring missed asperities, or counted
/// one a hundred times.
TEST(BodySum, DoesNotDependOnTheOrientationOfARoughFilm) {
    const auto film = momentsOf([](double x, double y) { return filmHeight(x, y, 0.0); });
    double largest = 0.0;
    for (const double angle : {0.3, 1.1, 2.5}) {
        const auto turned =
            momentsOf([angle](double x, double y) { return filmHeight(x, y, angle); });
        for (int i = 0; i < 8; ++i) {
            const double x = 120.0_nm * std::cos(0.785 * i);
            const double y = 120.0_nm * std::sin(0.785 * i);
            const TipState state = touching(*film, x, y);
            const TipState other = touching(*turned, x * std::cos(angle) + y * std::sin(angle),
                                            y * std::cos(angle) - x * std::sin(angle));
            const double expected = forceOn(*film, state).force / pullOff(state);
            EXPECT_NEAR(forceOn(*turned, other).force / pullOff(other), expected,
                        0.02 * std::abs(expected) + 0.002)
                << angle << ' ' << i;
            largest = std::max(largest, -expected);
        }
    }
    EXPECT_GT(largest, 0.05) << "there is attraction to compare";
}

TEST(BodySum, ItsGradientIsTheDerivative) {
    const auto film = momentsOf([](double x, double y) { return filmHeight(x, y, 0.0); });
    constexpr double kStep = 0.05_nm;
    for (const double gap : {0.0, 1.0_nm, 5.0_nm}) {
        for (int i = 0; i < 6; ++i) {
            const TipState state = touching(*film, 30.0_nm * i - 75.0_nm, 0.0, -gap);
            const BodyForce here = forceOn(*film, state);
            for (const Vector3& step : {Vector3(0.0, 0.0, kStep), Vector3(kStep, 0.0, 0.0)}) {
                TipState moved = state;
                moved.tip += step;
                const double change = forceOn(*film, moved).force - here.force;
                // The second derivative over the step, and squares that are cut otherwise.
                EXPECT_NEAR(here.gradient.dot(step), change,
                            0.1 * std::abs(change) + 5e-4 * pullOff(state))
                    << gap << ' ' << i << ' ' << step.transpose();
            }
        }
    }
}

/// A neighbor that has a contact of its own is as if it were not there.
TEST(BodySum, WhatAFurtherContactCountsIsTakenOff) {
    const double away = 180.0_nm;
    const double high = 8.0_nm + away * away / (2.0 * kTipRadius);  // it touches the tip, too
    const auto both = momentsOf([&](double x, double y) {
        return std::max(asperity(x, y, 8.0_nm), asperity(x - away, y, high));
    });
    const auto one = momentsOf([](double x, double y) { return asperity(x, y, 8.0_nm); });
    const TipState state = touching(*one);
    const ProbeSystem system = systemOn(nullptr);
    ContactPair pair = system.contact.pair();
    pair.tipRadius = state.effectiveRadius;
    const std::array points{
        state.closest.point,
        Vector3(kMiddle + away, kMiddle, both->surface().at(kMiddle + away, kMiddle).height)};
    const auto pullOn = [&](const HeightMoments& sample, std::size_t count) {
        return bodyForce(sample, bodyTraction(system, pair), state.tip, {points.data(), count},
                         state.closest.normal)
            .force;
    };
    const double seen = pullOn(*both, 1) - pullOn(*one, 1);
    EXPECT_LT(seen, 0.0);
    EXPECT_NEAR(pullOn(*both, 2), pullOn(*one, 1), 0.15 * std::abs(seen));
}

TEST(BodySum, WithoutAdhesionThereIsNone) {
    const auto bump = momentsOf([](double x, double y) { return asperity(x, y, 8.0_nm); });
    const TipState state = touching(*bump);
    BodyTraction traction = bodyTraction(systemOn(nullptr), {state.effectiveRadius, 53.4_GPa, 0.0});
    EXPECT_EQ(
        bodyForce(*bump, traction, state.tip, {&state.closest.point, 1}, Vector3::UnitZ()).force,
        0.0);
}

/// A blunt tip on a lever, on a bump of 4 nm.
class TipOnBump : public testing::Test {
protected:
    std::shared_ptr<const HeightMoments> sample_ =
        momentsOf([](double x, double y) { return asperity(x, y, 4.0_nm); });

    BaseMotion baseAt(double height, double x = 0.0) const {
        return {.position = {kMiddle + x, kMiddle,
                             sample_->surface().at(kMiddle, kMiddle).height + height}};
    }
};

TEST_F(TipOnBump, LeverContactAndBodyBalance) {
    const ProbeSystem system = systemOn(sample_);
    for (const double height : {50.0_nm, 5.0_nm, 0.0, -1.0_nm}) {
        EquilibriumMemory memory;
        const TipState state = tipEquilibrium(sample_->surface(), system, baseAt(height), memory);
        ASSERT_TRUE(state.converged) << height;
        const Vector3 deflection = state.tip - baseAt(height).position;
        EXPECT_LE((system.cantilever.compliance() * state.force - deflection).norm(), 1e-14);
        const double beside = forceOn(*sample_, state).force;
        EXPECT_LT(beside, 0.0);
        const double indentation = state.contact.indentation;
        EXPECT_NEAR(state.body.at(indentation), beside, 3e-4 * pullOff(state)) << height;
        const ContactModel law = system.contact.withTipRadius(state.effectiveRadius);
        const double bare = law.equilibrium(indentation, 0.0, state.contact.memory()).force;
        EXPECT_NEAR(state.contact.force, bare + beside, 3e-4 * pullOff(state)) << height;
    }
}

TEST_F(TipOnBump, OnAFlatSampleTheTermChangesNothing) {
    const auto flat = momentsOf([](double, double) { return 0.0; });
    for (const double height : {5.0_nm, 0.0, -1.0_nm}) {
        EquilibriumMemory with;
        EquilibriumMemory without;
        const BaseMotion base{.position = {kMiddle, kMiddle, height}};
        const BSplineSurface& surface = flat->surface();
        const Vector3 less = tipEquilibrium(surface, systemOn(nullptr), base, without).force;
        const Vector3 more = tipEquilibrium(surface, systemOn(flat), base, with).force;
        // A contact counts up to where 1e-4 of its pull-off force is left.
        EXPECT_LE((more - less).norm(), 2e-4 * 1.5 * std::numbers::pi * kWork * kTipRadius);
    }
}

/// Along and up and down in contact: the force at a position does not depend on the way there but
/// for what the gradient leaves out, and has no steps.
TEST_F(TipOnBump, AClosedLoopInContactReturnsToTheSameForces) {
    const ProbeSystem system = systemOn(sample_);
    EquilibriumMemory memory;
    std::vector<Vector3> first;
    Vector3 before = Vector3::Zero();
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i <= 400; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 400;
            const BaseMotion base =
                baseAt(-2.0_nm - 0.5_nm * std::cos(angle), 20.0_nm * std::sin(angle));
            const TipState state = tipEquilibrium(sample_->surface(), system, base, memory);
            ASSERT_TRUE(state.converged) << i;
            ASSERT_EQ(state.contact.branch, ContactBranch::Bonded) << i;
            if (i > 0) {
                EXPECT_LT((state.force - before).norm(), 1.0_nN) << i;
            }
            before = state.force;
            if (round == 0) {
                first.push_back(state.force);
            } else {
                EXPECT_LE((state.force - first[static_cast<std::size_t>(i)]).norm(),
                          4e-4 * pullOff(state))
                    << i;
            }
        }
    }
}

/// Work of a held tip along a straight way in the plane of x and z, in steps [J].
double workAlong(const HeightMoments& sample, const ProbeSystem& system, const Vector3& from,
                 const Vector3& to) {
    constexpr int kSteps = 400;
    const EquilibriumMemory memory;
    double work = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const BaseMotion tip{.position = from + (i + 0.5) / kSteps * (to - from)};
        work += heldTip(sample.surface(), system, tip, memory).force.dot(to - from) / kSteps;
    }
    return work;
}

/// Attraction beside does work on a closed loop in front of the sample only as far as its direction
/// is that of the contact's normal: a share of what it does along one side.
TEST_F(TipOnBump, AClosedLoopBeforeTheSampleTakesLittleWork) {
    const ProbeSystem system = systemOn(sample_);
    const double low = sample_->surface().at(kMiddle, kMiddle).height + 2.0_nm;
    const Vector3 a(kMiddle, kMiddle, low);
    const Vector3 b(kMiddle + 15.0_nm, kMiddle, low);
    const Vector3 up(0.0, 0.0, 10.0_nm);
    const auto work = [&](const Vector3& from, const Vector3& to) {
        return workAlong(*sample_, system, from, to);
    };
    const double side = work(a, a + up);
    const double loop = work(a, b) + work(b, b + up) + work(b + up, a + up) + work(a + up, a);
    EXPECT_LE(std::abs(loop), 0.05 * std::abs(side));
}

/// On a lever of 0.2 N/m the plane's attraction alone pulls the tip down: it ends in contact.
TEST_F(TipOnBump, AttractionThatOutrunsTheLeverEndsInContact) {
    const ProbeSystem soft = systemOn(sample_, 0.2);
    EquilibriumMemory memory;
    bool snapped = false;
    for (double height = 60.0_nm; height > 0.0 && !snapped; height -= 0.5_nm) {
        const TipState state = tipEquilibrium(sample_->surface(), soft, baseAt(height), memory);
        EXPECT_TRUE(state.converged) << height;
        snapped = state.contact.branch == ContactBranch::Bonded;
    }
    EXPECT_TRUE(snapped);
}

TEST_F(TipOnBump, TheTermAllocatesNothing) {
    const ProbeSystem system = systemOn(sample_);
    EquilibriumMemory memory;
    ClosestPointTracker tracker;
    const SampleSurface sample(sample_->surface());
    for (const double height : {20.0_nm, 0.0, -1.0_nm, 20.0_nm}) {
        const std::size_t count = test::allocationCount();
        (void)tipEquilibrium(sample, system, baseAt(height), memory, tracker);
        EXPECT_EQ(test::allocationCount(), count);
    }
}

}  // namespace
}  // namespace asperity
