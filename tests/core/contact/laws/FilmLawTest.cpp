#include "core/Error.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/FilmTable.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr ContactPair kPair{.tipRadius = 100e-9, .reducedModulus = 1e7};
constexpr ContactMemory kBonded{ContactBranch::Bonded};

ContactModel filmModel(double poissonRatio, double thickness = 20e-9,
                       const ContactPair& pair = kPair) {
    return {ContactLaw::HertzFilm,
            pair,
            {.filmThickness = thickness, .film = {.poissonRatio = poissonRatio}}};
}

TEST(FilmLaw, EqualsTheReference) {
    const test::ReferenceTable reference = test::referenceTable("T22_film_exact.csv");
    const double thickness = 20e-9;
    for (std::size_t row = 0; row < reference.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model = filmModel(reference.number(row, "nu"), thickness);
        const double chi = reference.number(row, "chi");
        const double halfSpace = chi * thickness;  // contact radius there
        const double indentation = halfSpace * halfSpace / kPair.tipRadius;
        const ContactState state = model.equilibrium(indentation, 0.0, kBonded);
        const double force = reference.number(row, "force_factor") * 4.0 / 3.0 *
                             kPair.reducedModulus * halfSpace * indentation;
        EXPECT_NEAR(state.force, force, 1e-9 * force);
        const double radius = reference.number(row, "radius_factor") * halfSpace;
        EXPECT_NEAR(state.contactRadius, radius, 1e-9 * radius);
        EXPECT_EQ(state.cohesiveRadius, state.contactRadius);
        EXPECT_NEAR(state.indentation, indentation, 1e-13 * indentation);
    }
}

TEST(FilmLaw, HasTheStiffnessOfItsForceOnAnyLever) {
    for (const double nu : {0.0, 0.3, 0.5}) {
        const ContactModel model = filmModel(nu);
        for (const double approach : {0.01e-9, 1e-9, 5e-9, 50e-9}) {
            for (const double compliance : {0.0, 0.1, 100.0}) {
                const ContactState here = model.equilibrium(approach, compliance, kBonded);
                EXPECT_NEAR(here.indentation + (compliance * here.force), approach,
                            1e-13 * approach);
                const double step = 1e-4 * here.indentation;
                const auto forceAt = [&](double at) {
                    return model.equilibrium(at, 0.0, kBonded).force;
                };
                const double slope =
                    (forceAt(here.indentation + step) - forceAt(here.indentation - step)) /
                    (2.0 * step);
                EXPECT_NEAR(here.stiffness, slope, 1e-6 * slope);
            }
        }
    }
}

TEST(FilmLaw, TakesTheSamplesPoissonRatioAndTheTipsCompliance) {
    const auto forceOf = [](const FilmElasticity& film) {
        const ContactModel model(ContactLaw::HertzFilm, kPair,
                                 {.filmThickness = 20e-9, .film = film});
        return model.equilibrium(5e-9, 0.0, kBonded).force;
    };
    const double rubber = forceOf({.poissonRatio = 0.5});
    EXPECT_GT(rubber, 1.2 * forceOf({.poissonRatio = 0.3}));
    EXPECT_GT(rubber, forceOf({.poissonRatio = 0.5, .share = 0.5}));
    const ContactModel hertz(ContactLaw::Hertz, kPair);
    EXPECT_NEAR(forceOf({.poissonRatio = 0.5, .share = 0.0}),
                hertz.equilibrium(5e-9, 0.0, kBonded).force, 1e-17);
}

TEST(FilmLaw, PressesWithItsForceAndTouchesTheTip) {
    const ContactModel model = filmModel(0.5);
    for (const double approach : {0.1e-9, 2e-9, 8e-9}) {
        const ContactState state = model.equilibrium(approach, 0.0, kBonded);
        const CohesiveContact profile = contactProfile(model, state);
        const double a = state.contactRadius;
        const double force = gaussLegendre(
            [&](double height) {
                const double r = a * std::sqrt((1.0 - height) * (1.0 + height));
                return 2.0 * std::numbers::pi * a * a * height * contactPressure(profile, r);
            },
            0.0, 1.0);
        EXPECT_NEAR(force, state.force, 1e-8 * state.force);
        EXPECT_EQ(contactPressure(profile, 1.01 * a), 0.0);
        EXPECT_EQ(surfaceDisplacement(model, state, 0.0), state.indentation);
        EXPECT_EQ(surfaceGap(profile, 0.9 * a), 0.0);
    }
}

TEST(FilmLaw, ServesOtherRadiiWithoutAllocating) {
    const ContactModel model = filmModel(0.4);
    const std::size_t before = test::allocationCount();
    const ContactModel other = model.withTipRadius(250e-9);
    const ContactState state = other.equilibrium(3e-9, 0.1, kBonded);
    const double pressure = contactPressure(contactProfile(other, state), 0.0);
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_GT(pressure, 0.0);
    const ContactModel same =
        filmModel(0.4, 20e-9, {.tipRadius = 250e-9, .reducedModulus = kPair.reducedModulus});
    EXPECT_EQ(state.force, same.equilibrium(3e-9, 0.1, kBonded).force);
}

TEST(FilmLaw, StaysFiniteAtTheEndsOfEveryRange) {
    for (const double nu : {0.0, 0.5}) {
        for (const double thickness : {1e-12, 1e-6, 1.0}) {
            for (const double radius : {1e-12, 1e-6, 1.0}) {
                for (const double modulus : {0.1, 1e15}) {
                    const ContactModel model = filmModel(nu, thickness, {radius, modulus, 0.0});
                    for (const double compliance : {0.0, 1.0, 1e6}) {
                        for (const double approach : {-1e3, 0.0, 1e-300, 1e-9, 1e3}) {
                            const ContactState state = model.equilibrium(approach, compliance, {});
                            ASSERT_TRUE(state.solved());
                            EXPECT_TRUE(std::isfinite(state.force) && state.force >= 0.0);
                            EXPECT_TRUE(std::isfinite(state.contactRadius));
                            EXPECT_TRUE(std::isfinite(state.stiffness));
                            EXPECT_TRUE(std::isfinite(state.energyLost));
                            EXPECT_TRUE(
                                std::isfinite(contactPressure(contactProfile(model, state), 0.0)));
                        }
                    }
                }
            }
        }
    }
}

TEST(FilmLaw, NeedsAFilmThatCanBe) {
    EXPECT_THROW(ContactModel(ContactLaw::HertzFilm, kPair), Error);
    EXPECT_THROW(filmModel(0.51), Error);
    EXPECT_THROW(filmModel(-0.01), Error);
    EXPECT_THROW(filmModel(std::nan("")), Error);
    EXPECT_THROW(filmModel(0.3, 10.0), Error);
    EXPECT_NO_THROW(ContactModel(ContactLaw::Hertz, kPair, {.film = {.poissonRatio = 7.0}}))
        << "a half-space";
}

}  // namespace
}  // namespace asperity
