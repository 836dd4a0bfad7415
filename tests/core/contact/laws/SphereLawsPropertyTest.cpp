#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <tuple>
#include <utility>

namespace asperity {
namespace {

using std::numbers::pi;

/// Any tip, sample and range of cohesion the laws are made for.
struct AnySphere {
    ContactPair pair;
    double stress;
    double compliance;
};

void showValue(const AnySphere& sphere, std::ostream& stream) {
    showValue(sphere.pair, stream);
    stream << ", sigma0 " << sphere.stress << " Pa, compliance " << sphere.compliance << " m/N";
}

rc::Gen<AnySphere> anySphere() {
    using rc::gen::tuple;
    return rc::gen::map(tuple(test::logUniform(1e-10, 1e-3), test::logUniform(1.0, 1e13),
                              test::logUniform(1e-9, 100.0), test::logUniform(1e-11, 1e-8),
                              test::anyCompliance()),
                        [](const std::tuple<double, double, double, double, double>& p) {
                            const auto [radius, modulus, work, range, compliance] = p;
                            return AnySphere{{radius, modulus, work}, work / range, compliance};
                        });
}

/// From before snap-in to 10 tip radii deep, dense around the fold.
double anySphereApproach(double fold, double radius) {
    const double where = *test::fraction();
    switch (*rc::gen::inRange(0, 5)) {
    case 0:
        return fold * (1.0 + ((where - 0.5) * 1e-6));
    case 1:
        return fold + (where * std::abs(fold));
    case 2:
        return -1e-6 * where;
    case 3:
        return fold + (radius * *test::logUniform(1e-12, 10.0));
    default:
        return 10.0 * radius * where;
    }
}

bool isFinite(const LawPoint& point) {
    return std::isfinite(point.force) && std::isfinite(point.indentation) &&
           std::isfinite(point.contactRadius) && std::isfinite(point.cohesiveRadius) &&
           std::isfinite(point.stiffness);
}

/// Sum of what cancels in the balance of a state.
double sizeOf(const AnySphere& sphere, const LawPoint& point, double approach) {
    const double radius = sphere.pair.tipRadius;
    const double c = point.cohesiveRadius;
    const double pull =
        sphere.stress * 4.0 * c * std::sqrt((c - point.contactRadius) * (c + radius)) +
        (2.0 * pi * sphere.pair.workOfAdhesion * radius) +
        std::sqrt(8.0 * pi * std::pow(c, 3) * sphere.pair.workOfAdhesion *
                  sphere.pair.reducedModulus);
    const double lift = pull / sphere.pair.reducedModulus / std::max(c, 1e-30);
    return std::abs(approach) + std::abs(point.indentation) + lift +
           (sphere.compliance * (std::abs(point.force) + pull)) +
           (sphere.pair.workOfAdhesion / sphere.stress);
}

template <typename Law>
void expectEquilibria(const Law& law, const AnySphere& sphere) {
    const LawPoint fold = law.fold(sphere.compliance);
    RC_ASSERT(isFinite(fold));
    const double end = fold.indentation + (sphere.compliance * fold.force);
    const double approach = anySphereApproach(end, sphere.pair.tipRadius);
    const auto state = law.stable(approach, sphere.compliance);
    if (!state) {
        RC_ASSERT(approach <= end + (1e-13 * sizeOf(sphere, fold, approach)));
        return;
    }
    RC_ASSERT(isFinite(*state));
    RC_ASSERT(state->contactRadius >= 0.0);
    RC_ASSERT(state->contactRadius <= sphere.pair.tipRadius);
    RC_ASSERT(state->cohesiveRadius >= state->contactRadius);
    RC_ASSERT(state->cohesiveRadius <= sphere.pair.tipRadius * (1.0 + 1e-15));
    const double off = state->indentation + (sphere.compliance * state->force) - approach;
    RC_ASSERT(std::abs(off) <= 1e-13 * sizeOf(sphere, *state, approach));
    RC_ASSERT(std::isfinite(law.energy(*state)));
    // Stable, whatever rounding leaves beside the fold itself.
    RC_ASSERT(approach <= end + (1e-6 * std::abs(end)) ||
              1.0 + (sphere.compliance * state->stiffness) >= -1e-9);
}

TEST(SphereLawsProperty, AreFiniteAndInEquilibriumForAnyMaterialAndLever) {
    test::checkProperty([] {
        AnySphere sphere = *anySphere();
        if (*rc::gen::inRange(0, 10) == 0) {
            sphere.pair.workOfAdhesion = 0.0;
        }
        expectEquilibria(SneddonLaw(sphere.pair), sphere);
        expectEquilibria(SphereJkrLaw(sphere.pair), sphere);
        expectEquilibria(SphereMaugisLaw(sphere.pair, sphere.stress), sphere);
    });
}

/// Corners of what the laws are made for, where a product or quotient is most likely to overflow.
TEST(SphereLawsProperty, StayFiniteInEveryCorner) {
    const auto expectFinite = [](const auto& law, const ContactPair& pair, double compliance) {
        EXPECT_TRUE(isFinite(law.fold(compliance)));
        for (const double approach :
             {-1e-6, -1e-9, 0.0, 1e-3 * pair.tipRadius, pair.tipRadius, 10.0 * pair.tipRadius}) {
            const auto state = law.stable(approach, compliance);
            EXPECT_TRUE(!state || isFinite(*state));
            EXPECT_TRUE(!state || std::isfinite(law.energy(*state)));
        }
    };
    for (const double radius : {1e-10, 1e-3}) {
        for (const double modulus : {1.0, 1e13}) {
            for (const double work : {0.0, 1e-30, 1e-9, 100.0}) {
                for (const double compliance : {0.0, 1e-6, 1e4}) {
                    const ContactPair pair{radius, modulus, work};
                    expectFinite(SneddonLaw(pair), pair, compliance);
                    expectFinite(SphereJkrLaw(pair), pair, compliance);
                    expectFinite(SphereMaugisLaw(pair, std::max(work, 1e-9) / 1e-12), pair,
                                 compliance);
                    expectFinite(SphereMaugisLaw(pair, std::max(work, 1e-9) / 1e-7), pair,
                                 compliance);
                }
            }
        }
    }
}

template <typename Law>
void expectMonotone(const Law& law, const AnySphere& sphere) {
    const LawPoint fold = law.fold(sphere.compliance);
    const double end = fold.indentation + (sphere.compliance * fold.force);
    const double low = end + (sphere.pair.tipRadius * *test::logUniform(1e-9, 5.0));
    const double high = low + (sphere.pair.tipRadius * *test::logUniform(1e-6, 1.0));
    const auto below = law.stable(low, sphere.compliance);
    const auto above = law.stable(high, sphere.compliance);
    RC_PRE(below && above);
    RC_ASSERT(above->contactRadius >= below->contactRadius * (1.0 - 1e-14));
    RC_ASSERT(above->cohesiveRadius >= below->cohesiveRadius * (1.0 - 1e-14));
    RC_ASSERT(above->indentation >= below->indentation - (1e-13 * sizeOf(sphere, *below, low)));
}

TEST(SphereLawsProperty, DeepenMonotonicallyAlongTheStableBranch) {
    test::checkProperty([] {
        const AnySphere sphere = *anySphere();
        expectMonotone(SneddonLaw(sphere.pair), sphere);
        expectMonotone(SphereJkrLaw(sphere.pair), sphere);
        expectMonotone(SphereMaugisLaw(sphere.pair, sphere.stress), sphere);
    });
}

/// Unit sphere and modulus with an adhesion that gives contacts from slight to wrapped.
rc::Gen<AnySphere> unitSphere() {
    return rc::gen::map(rc::gen::pair(test::logUniform(1e-3, 3.0), test::logUniform(0.02, 1.5)),
                        [](const std::pair<double, double>& p) {
                            return AnySphere{{1.0, 1.0, p.first}, p.first / p.second, 0.0};
                        });
}

/// Force is the slope of the energy, stiffness that of the force.
template <typename Law>
void expectSlopes(const Law& law, const AnySphere& sphere) {
    const double fold = law.fold(0.0).indentation;
    const double indentation = fold + *test::logUniform(0.03, 8.0);
    const double step = 1e-3 * (indentation - fold);
    const auto at = [&](double shift) { return *law.stable(indentation + (shift * step), 0.0); };
    const LawPoint middle = at(0.0);
    const double size = 1.0 + sphere.pair.workOfAdhesion + std::abs(middle.force);
    const auto slope = [&](const auto& value) {
        return ((8.0 * (value(at(1.0)) - value(at(-1.0)))) - (value(at(2.0)) - value(at(-2.0)))) /
               (12.0 * step);
    };
    // Where the zone meets contact or equator the third derivative is singular: keep off.
    const LawPoint below = at(-60.0);
    const LawPoint above = at(60.0);
    RC_PRE((below.contactRadius > 0.0) == (above.contactRadius > 0.0));
    RC_PRE((below.cohesiveRadius < 1.0) == (above.cohesiveRadius < 1.0));
    const double force = slope([&](const LawPoint& point) { return law.energy(point); });
    RC_ASSERT(std::abs(force - middle.force) <= 1e-8 * size);
    const double stiffness = slope([](const LawPoint& point) { return point.force; });
    RC_ASSERT(std::abs(stiffness - middle.stiffness) <= 1e-6 * (1.0 + std::abs(stiffness)));
}

TEST(SphereLawsProperty, HaveForceAndStiffnessAsSlopes) {
    test::checkProperty([] {
        const AnySphere sphere = *unitSphere();
        expectSlopes(SneddonLaw(sphere.pair), sphere);
        expectSlopes(SphereJkrLaw(sphere.pair), sphere);
        expectSlopes(SphereMaugisLaw(sphere.pair, sphere.stress), sphere);
    });
}

/// Value, slope and energy meet where the surfaces first touch and where the zone gets to the
/// equator.
TEST(SphereMaugisLaw, ContinuesSmoothlyAcrossTheFirstTouch) {
    test::checkProperty([] {
        const AnySphere sphere = *unitSphere();
        const SphereMaugisLaw law(sphere.pair, sphere.stress);
        const LawPoint touch = law.at(0.0);
        const double lift = 2.0 * sphere.stress / sphere.pair.reducedModulus;
        RC_ASSERT(std::abs(touch.indentation + (lift * touch.cohesiveRadius)) <= 1e-14 * lift);
        RC_PRE(touch.cohesiveRadius < 0.99);
        const LawPoint apart = law.apart(touch.cohesiveRadius);
        const double size = std::abs(touch.indentation) + touch.cohesiveRadius - law.onset();
        RC_ASSERT(std::abs(apart.indentation - touch.indentation) <= 1e-14 * size);
        RC_ASSERT(std::abs(apart.force - touch.force) <= 1e-14 * std::abs(touch.force));
        RC_ASSERT(std::abs(apart.stiffness - touch.stiffness) <= 1e-9 * std::abs(touch.stiffness));
        const LawPoint slight = law.at(1e-5);
        RC_ASSERT(std::abs(law.energy(slight) - law.energy(apart)) <=
                  1e-8 * (std::abs(law.energy(apart)) + sphere.pair.workOfAdhesion));
    });
}

/// Approach and retract on a rigid lever give a loop that never yields work.
TEST(SphereMaugisLaw, LosesEnergyInEveryLoop) {
    test::checkProperty([] {
        const AnySphere sphere = *anySphere();
        const SphereMaugisLaw law(sphere.pair, sphere.stress);
        const auto landing = law.stable(law.onset(), 0.0);
        const LawPoint fold = law.fold(0.0);
        RC_ASSERT(landing);
        const double size = pi * sphere.pair.workOfAdhesion * std::pow(landing->cohesiveRadius, 2);
        RC_ASSERT(law.energy(*landing) <= 1e-10 * size);
        RC_ASSERT(law.energy(fold) >= -1e-10 * size);
    });
}

}  // namespace
}  // namespace asperity
