#include "core/probe/TipEquilibrium.h"

#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/StorageError.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

Scene frictionless(const HeightMap& map) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.truth.material.friction = {};
    return buildScene(description, map);
}

TEST(TipEquilibrium, BalancesLeverAndContactOnAFlatSample) {
    const Scene scene = frictionless(test::flatMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -2.0_nm}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    ASSERT_TRUE(state.converged);
    const Vector3 deflection = scene.belief.cantilever.compliance() * state.force;
    EXPECT_LT((state.tip - base.position - deflection).norm(), 1e-15);
    // The contact law holds at the gap between the displaced tip and the surface.
    EXPECT_NEAR(state.contact.indentation, -state.tip.z(), 1e-15);
}

/// The contact opens by another work of adhesion than it closes by.
Scene withTwoWorks(const HeightMap& map, double ratio) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Jkr;
    description.sample.material.friction = {};
    description.sample.material.retractWork = ratio * description.sample.material.workOfAdhesion;
    description.truth.material = description.sample.material;
    return buildScene(description, map);
}

TEST(TipEquilibrium, AReversalHoldsTheContactAndNoCycleGivesEnergy) {
    const Scene scene = withTwoWorks(test::flatMap(), 1.5);
    EquilibriumMemory memory;
    double work = 0.0;  // of the base on the tip
    double z = 20.0_nm;
    double force = 0.0;
    double lowest = 0.0;
    const auto go = [&](double target) {
        constexpr int kSteps = 500;
        const double from = z;
        for (int i = 1; i <= kSteps; ++i) {
            const double next = from + ((target - from) * i / kSteps);
            const TipState state = tipEquilibrium(scene.surface, scene.belief,
                                                  {.position = {64.0_nm, 64.0_nm, next}}, memory);
            ASSERT_TRUE(state.converged) << next;
            work -= 0.5 * (state.force.z() + force) * (next - z);
            z = next;
            force = state.force.z();
            lowest = std::min(lowest, force);
        }
    };
    go(-3.0_nm);
    const double radius = memory.points[0].contact.contactRadius;
    EXPECT_GT(radius, 0.0);
    const double pressed = force;
    const double spent = work;
    go(-2.99_nm);
    EXPECT_EQ(memory.points[0].contact.contactRadius, radius);
    go(-3.0_nm);
    EXPECT_NEAR(force, pressed, 1e-9 * pressed);
    EXPECT_NEAR(work, spent, 1e-6 * spent) << "a small motion lost energy";
    for (const double target : {0.5_nm, -1.0_nm, 1.0_nm, -2.0_nm, 20.0_nm}) {
        go(target);
    }
    EXPECT_EQ(force, 0.0);
    EXPECT_GT(work, 0.0);
    const ContactModel one = scene.belief.contact.shrinking();
    EXPECT_NEAR(lowest / one.lastBonded(kMaxCompliance).force, 1.0, 0.02);
}

/// A lever over a slope feels the sample relax, and a wall drag it.
TEST(TipEquilibrium, ASampleThatRelaxesIsStiffAtOnce) {
    SceneDescription description = test::plainScene();
    SampleMaterial& material = description.sample.material;
    material.workOfAdhesion = 0.0;
    material.friction = {};
    material.relaxingModulus = 2.0 * material.elastic.youngsModulus;
    material.relaxationTime = 0.1;
    material.drag = 1e-12;
    material.dragOffset = 5.0_nm;
    description.truth.material = material;
    const Scene scene = buildScene(description, test::slopedMap(0.5));
    EquilibriumMemory memory;
    const auto at = [&](double z, double elapsed) {
        const TipState state = tipEquilibrium(
            scene.surface, scene.belief,
            {.position = {64.0_nm, 64.0_nm, z}, .velocity = {}, .elapsed = elapsed}, memory);
        EXPECT_TRUE(state.converged) << z;
        return state;
    };
    at(60.0_nm, 1e-3);
    const TipState nearing = at(59.0_nm, 1e-3);
    EXPECT_GT(nearing.force.z(), 0.0) << "drag";
    EXPECT_EQ(nearing.contact.contactRadius, 0.0);
    at(31.0_nm, 1e-3);
    const double pressed = at(30.0_nm, 1e-6).contact.indentation;
    const TipState relaxed = at(30.0_nm, std::numeric_limits<double>::infinity());
    EXPECT_GT(relaxed.contact.indentation, 1.2 * pressed);
    EquilibriumMemory fresh;
    const TipState slow = tipEquilibrium(scene.surface, scene.belief,
                                         {.position = {64.0_nm, 64.0_nm, 30.0_nm}}, fresh);
    EXPECT_NEAR(relaxed.force.norm() / slow.force.norm(), 1.0, 1e-12);
    EXPECT_LT(at(50.0_nm, 1e-3).force.z(), 0.0) << "drag holds the tip back";
}

TEST(TipEquilibrium, ForceIsAlongTheNormalOfASlopeWithoutFriction) {
    const Scene scene = frictionless(test::slopedMap(0.5));
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, 32.0_nm}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    ASSERT_TRUE(state.converged);
    const Vector3 normal = Vector3(-0.5, 0.0, 1.0).normalized();
    EXPECT_GT(state.contact.force, 1.0_nN);
    const double tilt = test::storageErrorOf(scene.surface).slope;
    EXPECT_LT((state.force - state.contact.force * normal).norm(),
              (1e-9 + tilt) * state.force.norm());
}

TEST(TipEquilibrium, FrictionIsMuNOpposedToMotion) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {.coefficient = 0.3, .shearStrength = 10.0_MPa};
    const Scene scene = buildScene(description, test::flatMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -2.0_nm}, .velocity = {0.0, 1e-6, 0.0}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    ASSERT_TRUE(state.converged);
    const double area =
        std::numbers::pi * state.contact.contactRadius * state.contact.contactRadius;
    const double friction = 0.3 * state.contact.force + 10.0_MPa * area;
    EXPECT_NEAR(state.force.y(), -friction, 1e-6 * friction);
    EXPECT_NEAR(state.force.x(), 0.0, 1e-9 * friction);
}

TEST(TipEquilibrium, SlidingTowardsTheClampSoftensTheLever) {
    // docs/theory.md 7.2, flat: 1/k_n = (1/kz)(1 + (3h/2l) mu fx) with fx = -sgn(vx).
    SceneDescription description = test::plainScene();
    description.sample.material.workOfAdhesion = 0.0;
    description.sample.material.friction.coefficient = 0.3;
    const Scene scene = buildScene(description, test::flatMap());
    const double ratio = 12.0 / 150.0;
    for (const double direction : {-1.0, 1.0}) {
        EquilibriumMemory memory;
        const BaseMotion base{.position = {64.0_nm, 64.0_nm, -2.0_nm},
                              .velocity = {direction * 1e-3, 0.0, 0.0}};
        const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        const double compliance = (1.0 - direction * 1.5 * ratio * 0.3) / 14.0;
        EXPECT_NEAR(state.contact.force * compliance, 2.0_nm - state.contact.indentation,
                    1e-6 * 2.0_nm);
    }
}

TEST(TipEquilibrium, NamesFrictionalLocking) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction.coefficient = 9.0;  // > 2 l / (3 h) = 8.33
    const Scene scene = buildScene(description, test::flatMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -1.0_nm}, .velocity = {1e-3, 0.0, 0.0}};
    EXPECT_TRUE(tipEquilibrium(scene.surface, scene.belief, base, memory).locked);
}

/// The state in tip's own words: what the lever does to the tip is what the sample answers.
void expectBalanced(const Scene& scene, const BaseMotion& base, const TipState& state) {
    const Vector3 deflection = scene.belief.cantilever.compliance() * state.force;
    EXPECT_LT((state.tip - base.position - deflection).norm(), 2e-15);
}

TEST(TipEquilibrium, AHillIsMetWithItsEffectiveRadius) {
    const Scene scene = frictionless(test::hillyMap());
    EquilibriumMemory memory;
    const BaseMotion base{.position = {15.0_nm, 15.0_nm, 4.0_nm}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    ASSERT_TRUE(state.converged);
    const double wave = 2.0 * std::numbers::pi / 60.0_nm;
    const double radius = 1.0 / ((1.0 / 15.0_nm) + 6.0_nm * wave * wave);
    EXPECT_NEAR(state.effectiveRadius, radius, 0.01 * radius);
    const ContactModel onHill = scene.belief.contact.withTipRadius(state.effectiveRadius);
    const ContactState flat = onHill.equilibrium(state.contact.indentation, 0.0,
                                                 ContactMemory{ContactBranch::Bonded, 0.0});
    EXPECT_NEAR(state.contact.force, flat.force, 1e-9 * std::abs(flat.force) + 1e-15);
    EXPECT_EQ(state.points, 1);
    expectBalanced(scene, base, state);
}

/// Whether a tip may lack a neck that it may have lacked before, with its base at this height [m].
bool mayStillLackPoint(const Scene& scene, double height) {
    EquilibriumMemory memory;
    memory.mayLackPoint = true;
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, height}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    EXPECT_FALSE(mayMissPoints(state.proof));
    EXPECT_EQ(memory.mayLackPoint, state.mayLackPoint);
    return state.mayLackPoint;
}

TEST(TipEquilibrium, ADoubtAboutMissedContactsLastsUntilTheTipIsFree) {
    const Scene scene = frictionless(test::flatMap());
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    // As far as this many necks hold it together.
    const double held = -scene.belief.contact.pullOffApproach(kMaxContactPoints * compliance);
    EXPECT_TRUE(mayStillLackPoint(scene, -2.0_nm));
    EXPECT_TRUE(mayStillLackPoint(scene, 0.9 * held));
    EXPECT_FALSE(mayStillLackPoint(scene, 1.1 * held));
}

TEST(TipEquilibrium, WhereNothingAdheresThereIsNoDoubtAboutMissedContacts) {
    SceneDescription description = test::plainScene();
    description.sample.material.workOfAdhesion = 0.0;
    description.truth.material.workOfAdhesion = 0.0;
    EXPECT_FALSE(mayStillLackPoint(buildScene(description, test::flatMap()), -2.0_nm));
}

/// A sample whose curvature changes within a contact, as that of a grainy film.
HeightMap grainyMap() {
    HeightMap map = test::flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double x = map.pitchX * column;
            const double y = map.pitchY * row;
            map.heights[map.index(row, column)] =
                0.03_nm * (std::sin(x / 1.5_nm + 0.3) * std::sin(y / 1.8_nm) +
                           std::sin((x + 0.7 * y) / 2.3_nm)) +
                2.0_nm * std::cos(x / 14.0_nm) * std::cos(y / 17.0_nm);
        }
    }
    return map;
}

/// How a tip is pulled off.
struct PullOff {
    int unsolved = 0;     ///< fine steps before the jump without an equilibrium
    bool isFree = false;  ///< and the tip is, after the jump, in an equilibrium
    bool jumped = false;  ///< and the state that is free again says so, with the energy
};

/// Coarse steps until the last one before the jump, then fine ones through it.
PullOff pullOffAt(const Scene& scene, double x, double y) {
    constexpr double kCoarse = 0.02_nm;
    constexpr double kFine = 0.0002_nm;
    EquilibriumMemory memory;
    PullOff result;
    double z = scene.surface.at(x, y).height - 2.0_nm;
    double step = kCoarse;
    for (int i = 0; i < 2000; ++i) {
        EquilibriumMemory next = memory;
        const BaseMotion base{.position = {x, y, z}, .velocity = {0.0, 0.0, 20.0_nm}};
        const TipState state = tipEquilibrium(scene.surface, scene.belief, base, next);
        const bool isFree = i > 0 && state.contact.branch == ContactBranch::Far;
        if (isFree && step == kCoarse) {
            step = kFine;  // from the step before
            z += kFine - kCoarse;
            continue;
        }
        memory = next;
        if (isFree) {
            result.isFree = state.converged;
            result.jumped = state.contact.jumped && state.contact.energyLost > 0.0;
            return result;
        }
        result.unsolved += state.converged ? 0 : 1;
        z += step;
    }
    ADD_FAILURE() << "still bonded";
    return result;
}

/// Where the lever bends to the side the contact point moves with the force, and with it the
/// effective radius: in the last tick of a pull-off the bond broke at one position and held at the
/// other, and no equilibrium was found, although the free tip has one.
TEST(TipEquilibrium, IsFoundThroughAPullOff) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 30.0_nm;
    const Scene scene = buildScene(description, grainyMap());
    for (int index = 0; index < 100; ++index) {
        const double x = 30.0_nm + 6.1_nm * (index % 10);
        const double y = 32.0_nm + 5.3_nm * (index / 10);
        const PullOff pulled = pullOffAt(scene, x, y);
        EXPECT_TRUE(pulled.isFree) << x << ", " << y;
        EXPECT_LE(pulled.unsolved, 1) << "the search slows down at the very end of the branch";
        EXPECT_TRUE(pulled.jumped) << x << ", " << y;
    }
}

TEST(TipEquilibrium, AnExactSphereTakesAHillAsFlatAndSaysSo) {
    for (const bool onHill : {true, false}) {
        SceneDescription description = test::plainScene();
        description.choices.law = ContactLaw::SphereMaugis;
        const Scene scene = buildScene(description, onHill ? test::hillyMap() : test::flatMap());
        EquilibriumMemory memory;
        const BaseMotion base{.position = {15.0_nm, 15.0_nm, onHill ? 4.0_nm : -2.0_nm}};
        const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        ASSERT_GT(state.contact.contactRadius, 0.0);
        EXPECT_EQ(state.effectiveRadius, scene.belief.tipRadius());
        EXPECT_EQ(state.anisotropic, onHill);
    }
}

TEST(TipEquilibrium, RestsOnBothFlanksOfAGrooveItDoesNotFit) {
    const Scene scene = frictionless(test::ridgedMap(25.0_nm));
    for (const double aside : {0.0, 0.5}) {
        SCOPED_TRACE(aside);
        EquilibriumMemory memory;
        const BaseMotion base{.position = {45.0_nm + aside * 1.0_nm, 64.0_nm, -17.0_nm}};
        TipState state;
        for (int i = 0; i < 3; ++i) {
            state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        }
        ASSERT_TRUE(state.converged);
        EXPECT_EQ(state.points, 2);
        expectBalanced(scene, base, state);
        // Held at the same position by a rigid lever, the sample pushes the same way.
        const TipState held = heldTip(scene.surface, scene.belief, {.position = state.tip}, memory);
        EXPECT_LT((held.force - state.force).norm(), 1e-6 * state.force.norm());
        EXPECT_GT(state.force.z(), 1.0_nN);
    }
}

/// A beam along the groove leans along it, so that the tip stays in its middle.
TEST(TipEquilibrium, FlanksOfAGrooveShareTheLoad) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.probe.azimuth = std::numbers::pi / 2.0;
    const Scene scene = buildScene(description, test::ridgedMap(25.0_nm));
    EquilibriumMemory memory;
    const BaseMotion base{.position = {45.0_nm, 64.0_nm, -17.0_nm}};
    const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    ASSERT_EQ(state.points, 2);
    EXPECT_LT(std::abs(state.force.x()), 1e-3 * state.force.z());
    EXPECT_NEAR(state.force.z(), 2.0 * state.contact.force * state.closest.normal.z(),
                1e-3 * state.force.z());
}

/// Neither flank bears the lever's pull alone: each lets go at its own strongest pull, whatever the
/// steps in which the base goes up.
TEST(TipEquilibrium, FlanksOfAGrooveHoldTheTipTogether) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.probe.azimuth = std::numbers::pi / 2.0;
    description.probe.thickness = thicknessForStiffness(description.probe, 0.05);
    const Scene scene = buildScene(description, test::ridgedMap(25.0_nm));
    for (const double step : {0.2_nm, 12.0_nm}) {
        SCOPED_TRACE(step);
        EquilibriumMemory memory;
        BaseMotion base{.position = {45.0_nm, 64.0_nm, -20.0_nm}};
        TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        ASSERT_EQ(state.points, 2);
        TipState last;
        while (state.contact.branch == ContactBranch::Bonded && state.converged) {
            last = state;
            base.position.z() += step;
            state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        }
        EXPECT_EQ(last.points, 2);
        const double strongest =
            contactModelAt(scene.belief, last).lastBonded(kMaxCompliance).force;
        const double expected = 2.0 * strongest * last.closest.normal.z();
        EXPECT_NEAR(last.force.z(), expected, 0.02 * std::abs(expected));
    }
}

/// Friction that drags the tip deeper faster than a plain fixed point converges, on a steep flank.
TEST(TipEquilibrium, SlidesDownASteepSlopeUnderStrongFriction) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27};
    description.sample.material.workOfAdhesion = 0.2;
    const double slope = std::tan(std::numbers::pi / 3.0);
    for (const double mu : {0.3, 0.6, 0.8}) {
        description.sample.material.friction = {.coefficient = mu, .shearStrength = 0.0};
        const Scene scene = buildScene(description, test::slopedMap(slope));
        EquilibriumMemory memory;
        for (int i = 0; i <= 100; ++i) {
            const BaseMotion base{
                .position = {64.0_nm, 64.0_nm, 64.0_nm * slope + 17.0_nm - i * 0.05_nm},
                .velocity = {0.0, 0.0, -1e-7}};
            const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
            ASSERT_TRUE(state.converged) << mu << ", " << i;
            ASSERT_FALSE(state.locked);
            expectBalanced(scene, base, state);
        }
        EXPECT_EQ(memory.points[0].contact.branch, ContactBranch::Bonded);
    }
}

/// With N < 0 and friction of the area alone, T = max(0, mu N + tau A).
TEST(TipEquilibrium, AdhesiveContactSlidesByItsAreaAlone) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {.coefficient = 0.1, .shearStrength = 100.0_MPa};
    const Scene scene = buildScene(description, test::flatMap());
    EquilibriumMemory memory;
    TipState state;
    for (const double depth : {-1.0_nm, 0.0_nm}) {
        const BaseMotion base{.position = {64.0_nm, 64.0_nm, depth}, .velocity = {0.0, 1e-6, 0.0}};
        state = tipEquilibrium(scene.surface, scene.belief, base, memory);
    }
    ASSERT_TRUE(state.converged);
    ASSERT_LT(state.contact.force, 0.0);
    const double expected = 0.1 * state.contact.force + 100.0_MPa * state.contactArea;
    ASSERT_GT(expected, 0.0);
    EXPECT_NEAR(state.force.y(), -expected * state.slip.norm(), 1e-9 * expected);
}

/// Where pull-off is once friction of the area takes part: the lowest base position of any state.
double pullOffWithAreaFriction(const Scene& scene, double across) {
    const ContactModel& law = scene.belief.contact;
    const double along = scene.belief.cantilever.compliance()(2, 2);
    const double strength = scene.belief.friction.shearStrength;
    double lowest = 0.0;
    ContactMemory memory{ContactBranch::Bonded, 0.0};
    for (double depth = 1.0_nm; memory.branch == ContactBranch::Bonded; depth -= 0.02_pm) {
        const ContactState state = law.equilibrium(depth, 0.0, memory);
        memory = state.memory();
        const double area = std::numbers::pi * state.contactRadius * state.contactRadius;
        lowest = std::min(lowest, depth + along * state.force + across * strength * area);
    }
    return lowest;
}

/// At 1 GPa friction of the area moves pull-off by some 3 pm: up to its fold where it lifts the
/// tip, and to within as much where it drags the tip down.
TEST(TipEquilibrium, PullsOffALittleLaterOrEarlierUnderAreaFriction) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27};
    description.sample.material.workOfAdhesion = 0.2;
    description.sample.material.friction = {.coefficient = 0.0, .shearStrength = 1.0_GPa};
    const Scene scene = buildScene(description, test::flatMap());
    for (const double direction : {-1.0, 1.0}) {
        const double across = -direction * scene.belief.cantilever.compliance()(2, 0);
        const double expected = pullOffWithAreaFriction(scene, across);
        EquilibriumMemory memory;
        memory.points[0].contact.branch = ContactBranch::Bonded;
        memory.pointCount = 1;
        double left = 0.0;
        for (double height = 0.0; height < 2.0_nm; height += 0.1_pm) {
            const BaseMotion base{.position = {64.0_nm, 64.0_nm, height},
                                  .velocity = {direction * 1e-3, 0.0, 0.0}};
            const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
            EXPECT_TRUE(state.converged || across > 0.0) << height;
            if (memory.points[0].contact.branch == ContactBranch::Far) {
                left = -height;
                break;
            }
        }
        EXPECT_NEAR(left, expected, across < 0.0 ? 0.11_pm : 3.0_pm) << direction;
    }
}

TEST(TipEquilibrium, AddsUpTheAreasOfItsClosestPoints) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.probe.azimuth = std::numbers::pi / 2.0;
    const Scene scene = buildScene(description, test::ridgedMap(25.0_nm));
    EquilibriumMemory memory;
    const TipState state = tipEquilibrium(scene.surface, scene.belief,
                                          {.position = {45.0_nm, 64.0_nm, -17.0_nm}}, memory);
    ASSERT_EQ(state.points, 2);
    const double radius = state.contact.contactRadius;
    EXPECT_NEAR(state.contactArea, 2.0 * std::numbers::pi * radius * radius,
                1e-3 * state.contactArea);
}

/// A soft lever lifts the tip by much: its closest points are others than those of the undeflected
/// tip, and none of them may wait for the next tick.
TEST(TipEquilibrium, FindsItsClosestPointsWithinOneTickHoweverFarItMoves) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.sample.material.workOfAdhesion = 0.0;
    description.probe.thickness = thicknessForStiffness(description.probe, 0.2);
    const Scene scene = buildScene(description, test::ridgedMap(8.0_nm));
    for (int i = 0; i <= 150; ++i) {
        const double x = 45.0_nm - i * 0.1_nm;
        const double height = scene.surface.at(x, 64.0_nm).height;
        const BaseMotion base{.position = {x, 64.0_nm, height - 12.0_nm}};
        EquilibriumMemory memory;
        const TipState first = tipEquilibrium(scene.surface, scene.belief, base, memory);
        const TipState settled = tipEquilibrium(scene.surface, scene.belief, base, memory);
        ASSERT_TRUE(first.converged) << i;
        // The effective radius is followed to 1e-6.
        ASSERT_NEAR(first.force.z(), settled.force.z(), 1e-5 * settled.force.norm()) << i;
    }
}

TEST(TipEquilibrium, ForceIsContinuousAcrossAGrooveWithoutAdhesion) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.sample.material.workOfAdhesion = 0.0;
    const Scene scene = buildScene(description, test::ridgedMap(25.0_nm));
    EquilibriumMemory memory;
    double before = 0.0;
    for (int i = 0; i <= 400; ++i) {
        const double x = 43.0_nm + i * 0.01_nm;
        const BaseMotion base{.position = {x, 64.0_nm, -17.0_nm}};
        const TipState state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        ASSERT_TRUE(state.converged) << i;
        if (i > 0) {
            EXPECT_NEAR(state.force.z(), before, 0.3_nN) << i;
        }
        before = state.force.z();
    }
}

/// Pressed far into a soft bump: below the bump's center of curvature the tip's center has no
/// single closest point any more, and each of several would bear a whole contact.
TEST(TipEquilibrium, ASubmergedTipHasOneContact) {
    SceneDescription description = test::plainScene();
    description.sample.material = {.elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5},
                                   .workOfAdhesion = 0.0,
                                   .friction = {}};
    description.choices.law = ContactLaw::Sneddon;
    const Scene scene = buildScene(description, test::hillyMap());
    const ContactPair& pair = scene.belief.contact.pair();
    const double stiffest =
        2.0 * pair.tipRadius * pair.reducedModulus;  // 2 a E*, docs/theory.md 4.1
    EquilibriumMemory memory;
    TipState before;
    for (int i = 0; i <= 400; ++i) {
        const double depth = i * 0.01 * pair.tipRadius;
        const BaseMotion base{.position = {15.3_nm, 14.9_nm, 6.0_nm - depth}};
        const TipState state = tipEquilibrium(scene.believedSurface(), scene.belief, base, memory);
        ASSERT_TRUE(state.converged) << i;
        EXPECT_EQ(state.points, 1) << i;
        if (i > 0) {
            const double rise = state.force.z() - before.force.z();
            EXPECT_GT(rise, 0.0) << i;
            EXPECT_LT(rise, 1.01 * stiffest * (before.tip.z() - state.tip.z())) << i;
        }
        before = state;
    }
    EXPECT_GT(before.contact.indentation, 3.9 * pair.tipRadius);
}

TEST(SimulatedAfm, SignalsAreThoseOfTheTrueForcePlusSeededNoise) {
    SceneDescription description = test::plainScene();
    description.truth.signalNoise = 0.0;
    const Scene quiet = buildScene(description, test::flatMap());
    description.truth.signalNoise = 1e-7;
    const Scene noisy = buildScene(description, test::flatMap());
    const BaseMotion base{.position = {64.0_nm, 64.0_nm, -2.0_nm}};

    SimulatedAfm exact(quiet.surface, truthOf(quiet));
    const AfmMeasurement clean = exact.exchange(base);
    const LeverSignals expected =
        leverSignals(truthOf(quiet).system.cantilever, exact.trueState().force);
    EXPECT_EQ(clean.signals.bending, expected.bending);
    EXPECT_EQ(clean.age, 0.0);

    SimulatedAfm first(noisy.surface, truthOf(noisy));
    SimulatedAfm second(noisy.surface, truthOf(noisy));
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kDraws = 4000;
    for (int i = 0; i < kDraws; ++i) {
        const LeverSignals signals = first.exchange(base).signals;
        ASSERT_EQ(signals.torsion, second.exchange(base).signals.torsion) << "same seed";
        const double noise = (signals.bending - expected.bending) / 1e-7;
        sum += noise / kDraws;
        squares += noise * noise / kDraws;
    }
    EXPECT_NEAR(sum, 0.0, 5.0 / std::sqrt(kDraws));
    EXPECT_NEAR(squares, 1.0, 5.0 * std::sqrt(2.0 / kDraws));
}

}  // namespace
}  // namespace asperity
