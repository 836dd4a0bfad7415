#include "core/Error.h"
#include "core/contact/ContactState.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/contact/maugis/MaugisTable.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace asperity {
namespace {

using test::isFinite;
using test::kInfinity;
using test::kNan;

using Limits = std::numeric_limits<double>;

/// Everything a file or a command line may hold instead of a number.
constexpr std::array kOddNumbers{
    kNan,   kInfinity, -kInfinity,    0.0,           -0.0,           -1.0,  Limits::denorm_min(),
    1e-310, 1e-300,    Limits::min(), Limits::max(), -Limits::max(), 1e300, 1e-30,
    1e30};

constexpr std::array kSolvers{SolverSetting::Exact, SolverSetting::Newton, SolverSetting::Table};

/// Either a model that works, or one sentence that says why there is none.
void expectModelOrSentence(ContactLaw law, const ContactPair& pair, const ContactOptions& options) {
    try {
        const ContactModel model(law, pair, options);
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            const ContactState state = model.equilibrium(1e-9, 0.1, {branch});
            EXPECT_TRUE(state.solved());
            EXPECT_TRUE(isFinite(state));
        }
    } catch (const Error& error) {
        const std::string sentence = error.what();
        EXPECT_EQ(sentence.rfind("contact: ", 0), 0U) << sentence;
        EXPECT_GT(sentence.size(), 30U);
        EXPECT_EQ(sentence.find('\n'), std::string::npos);
    }
}

ContactOptions optionsFor(ContactLaw law) {
    return {.filmThickness = law == ContactLaw::HertzFilm ? 1e-7 : 0.0};
}

TEST(ContactRefusal, AModelOfOddNumbersWorksOrIsRefusedInOneSentence) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        for (const double odd : kOddNumbers) {
            SCOPED_TRACE(odd);
            const ContactOptions options = optionsFor(law);
            expectModelOrSentence(law, {odd, 1e9, 0.05}, options);
            expectModelOrSentence(law, {15e-9, odd, 0.05}, options);
            expectModelOrSentence(law, {15e-9, 1e9, odd}, options);
            expectModelOrSentence(law, {odd, odd, odd}, options);
        }
    }
}

TEST(ContactRefusal, OddOptionsWorkOrAreRefusedInOneSentence) {
    const ContactPair pair{15e-9, 1e9, 0.05};
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        for (const double odd : kOddNumbers) {
            SCOPED_TRACE(odd);
            ContactOptions options = optionsFor(law);
            options.cohesiveStress = odd;
            expectModelOrSentence(law, pair, options);
            expectModelOrSentence(law, pair, {.filmThickness = odd});
            options = optionsFor(law);
            for (const Meniscus& meniscus : {Meniscus{odd, 0.3, 1e-9}, Meniscus{0.07, odd, 1e-9},
                                             Meniscus{0.07, 0.3, odd}, Meniscus{odd, odd, odd}}) {
                options.meniscus = meniscus;
                expectModelOrSentence(law, pair, options);
            }
        }
    }
}

TEST(ContactRefusal, RefusesWhatIsOutsideItsRange) {
    for (const ContactPair& pair :
         {ContactPair{0.9e-12, 1e9, 0.1}, ContactPair{1.1, 1e9, 0.1}, ContactPair{1e-8, 0.09, 0.1},
          ContactPair{1e-8, 1.1e15, 0.1}, ContactPair{1e-8, 1e9, 1.1e3},
          ContactPair{1e-8, 1e9, -1e-300}}) {
        EXPECT_THROW(ContactModel(ContactLaw::Hertz, pair), Error);
    }
    const ContactPair pair{1e-8, 1e9, 0.1};
    EXPECT_THROW(ContactModel(ContactLaw::HertzFilm, pair), Error);
    EXPECT_THROW(ContactModel(ContactLaw::Maugis, pair, {.cohesiveStress = 1e30}), Error);
    EXPECT_THROW(ContactModel(ContactLaw::Maugis, pair, {.cohesiveStress = -1.0}), Error);
    EXPECT_THROW(ContactModel(ContactLaw::Hertz, pair, {.meniscus = {0.07, 0.0, 1e-13}}), Error);
}

/// Any approach, lever and memory: a state or a named status, on every law by every solver.
TEST(ContactRefusal, AnEquilibriumOfOddNumbersIsSolvedOrSaysWhyNot) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        for (const SolverSetting solver : kSolvers) {
            ContactOptions options = optionsFor(law);
            options.solver = solver;
            for (const double tension : {0.0, 0.07}) {
                options.meniscus = {tension, 0.3, 2e-9};
                const ContactModel model(law, {15e-9, 1e9, 0.05}, options);
                for (const double approach : kOddNumbers) {
                    for (const double compliance : kOddNumbers) {
                        for (const double coordinate : {0.0, kNan, 1e300, -1.0, 1e-310}) {
                            SCOPED_TRACE(approach);
                            SCOPED_TRACE(compliance);
                            const ContactState state = model.equilibrium(
                                approach, compliance, {ContactBranch::Bonded, coordinate});
                            const bool asked =
                                checkRequest(approach, compliance) == ContactStatus::Solved;
                            EXPECT_EQ(state.solved(), asked);
                            EXPECT_TRUE(isFinite(state));
                            EXPECT_NE(std::string(keyOf(state.status)), "unknown");
                        }
                    }
                }
            }
        }
    }
}

TEST(ContactRefusal, FoldsOnAnOddLeverAreThoseOfTheNearestOne) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        for (const double tension : {0.0, 0.07}) {
            ContactOptions options = optionsFor(law);
            options.meniscus = {tension, 0.3, 2e-9};
            const ContactModel model(law, {15e-9, 1e9, 0.05}, options);
            for (const double odd : kOddNumbers) {
                SCOPED_TRACE(odd);
                const double nearest = nearestCompliance(odd);
                EXPECT_GE(nearest, 0.0);
                EXPECT_LE(nearest, kMaxCompliance);
                EXPECT_EQ(model.jumpInApproach(odd), model.jumpInApproach(nearest));
                EXPECT_EQ(model.pullOffApproach(odd), model.pullOffApproach(nearest));
                EXPECT_TRUE(std::isfinite(model.jumpInApproach(odd)));
                EXPECT_TRUE(std::isfinite(model.pullOffApproach(odd)));
                EXPECT_TRUE(isFinite(model.lastBonded(odd)));
            }
        }
    }
}

TEST(ContactRefusal, AnOddTipRadiusCountsAsTheNearest) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        const ContactModel model(law, {15e-9, 1e9, 0.05}, optionsFor(law));
        EXPECT_EQ(model.withTipRadius(kNan).pair().tipRadius, 15e-9);
        for (const double odd : kOddNumbers) {
            SCOPED_TRACE(odd);
            const ContactModel curved = model.withTipRadius(odd);
            EXPECT_GE(curved.pair().tipRadius, kMinTipRadius);
            EXPECT_LE(curved.pair().tipRadius, kMaxTipRadius);
            EXPECT_TRUE(isFinite(curved.equilibrium(1e-9, 0.1, {ContactBranch::Bonded})));
        }
    }
}

TEST(ContactRefusal, ATipOnAnOddSurfaceDoesNotFit) {
    for (const double odd : kOddNumbers) {
        SCOPED_TRACE(odd);
        for (const EffectiveRadius& radius :
             {effectiveRadius(odd, 1e6, -1e6), effectiveRadius(15e-9, odd, 0.0),
              effectiveRadius(15e-9, 0.0, odd), effectiveRadius(odd, odd, odd)}) {
            EXPECT_TRUE(!radius.tipFits || (radius.radius > 0.0 && std::isfinite(radius.radius)));
        }
    }
    EXPECT_FALSE(effectiveRadius(15e-9, kNan, 0.0).tipFits);
    EXPECT_FALSE(effectiveRadius(kInfinity, 0.0, 0.0).tipFits);
    EXPECT_FALSE(effectiveRadius(15e-9, 0.0, -1.0 / 15e-9).tipFits);
}

TEST(ContactRefusal, BodiesWithoutAModulusHaveNone) {
    const Elastic silicon{169e9, 0.27};
    for (const double odd : kOddNumbers) {
        SCOPED_TRACE(odd);
        for (const Elastic& body : {Elastic{odd, 0.3}, Elastic{1e9, odd}, Elastic{odd, odd}}) {
            const double modulus = reducedModulus(body, silicon);
            EXPECT_GE(modulus, 0.0);
            EXPECT_EQ(reducedModulus(silicon, body), modulus);
            const double share = sampleShare(body, silicon);
            EXPECT_TRUE(share >= 0.0 && share <= 1.0);
        }
    }
    EXPECT_EQ(reducedModulus({0.0, 0.3}, silicon), 0.0);
    EXPECT_EQ(reducedModulus({kNan, 0.3}, silicon), 0.0);
    EXPECT_EQ(reducedModulus({1e9, 0.51}, silicon), 0.0);
    EXPECT_EQ(reducedModulus({kInfinity, 0.3}, {kInfinity, 0.3}), kInfinity);
    EXPECT_THROW(ContactModel(ContactLaw::Hertz, {15e-9, kInfinity, 0.0}), Error);
}

TEST(ContactRefusal, NoLawIsChosenForAnOddPair) {
    for (const double odd : kOddNumbers) {
        SCOPED_TRACE(odd);
        for (const ContactPair& pair : {ContactPair{odd, 1e9, 0.05}, ContactPair{15e-9, odd, 0.05},
                                        ContactPair{15e-9, 1e9, odd}}) {
            const bool usable = checkPair(pair, pair.workOfAdhesion) == ContactStatus::Solved;
            if (usable) {
                EXPECT_NE(chooseLaw({}, pair).reason, LawReason::AskedFor);
            } else {
                EXPECT_THROW((void)chooseLaw({}, pair), Error);
            }
        }
    }
}

TEST(ContactRefusal, AForceCurveNeedsALeverAndAWay) {
    const ContactModel model(ContactLaw::Split, {15e-9, 1e9, 0.05});
    for (const double bad : {kNan, kInfinity, -kInfinity, -1.0, 2e6, Limits::max()}) {
        EXPECT_THROW((void)curvePlan(model, bad), Error);
        EXPECT_THROW((void)forceCurve(model, bad, {-1e-8, 1e-8, 10}), Error);
    }
    for (const double bad : {kNan, kInfinity, -kInfinity, 2e3, -Limits::max()}) {
        EXPECT_THROW((void)forceCurve(model, 0.1, {bad, 1e-8, 10}), Error);
        EXPECT_THROW((void)forceCurve(model, 0.1, {-1e-8, bad, 10}), Error);
    }
    EXPECT_THROW((void)forceCurve(model, 0.1, {1e-8, -1e-8, 10}), Error);
    for (const int points :
         {std::numeric_limits<int>::min(), -1, 0, 1, std::numeric_limits<int>::max()}) {
        EXPECT_THROW((void)forceCurve(model, 0.1, {-1e-8, 1e-8, points}), Error);
    }
    EXPECT_EQ(forceCurve(model, 0.1, {-1e-8, 1e-8, 2}).approach.size(), 4U);  // and the jump
}

TEST(ContactRefusal, TheSurfaceDoesNotMoveAtAnOddRadius) {
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(nameOf(law));
        const ContactModel model(law, {15e-9, 1e9, 0.05}, optionsFor(law));
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            for (const double approach : {-5e-9, -1e-10, 1e-9}) {
                const ContactState state = model.equilibrium(approach, 0.1, {branch});
                for (const double odd : kOddNumbers) {
                    SCOPED_TRACE(odd);
                    EXPECT_TRUE(std::isfinite(surfaceDisplacement(model, state, odd)));
                }
                EXPECT_EQ(surfaceDisplacement(model, state, kNan), 0.0);
                EXPECT_EQ(surfaceDisplacement(model, state, kInfinity), 0.0);
            }
        }
    }
}

TEST(ContactRefusal, ATableOfOddNumbersIsRefusedOrLeavesThemToTheLaw) {
    for (const double odd : kOddNumbers) {
        SCOPED_TRACE(odd);
        EXPECT_THROW(MaugisTable({odd, odd, 10.0}), Error);
        EXPECT_THROW(MaugisTable({1.0, odd, 10.0}), Error);
    }
    EXPECT_THROW(MaugisTable({1.0, 1.0, kNan}), Error);
    EXPECT_THROW(MaugisTable({1.0, 1.0, -1.0}), Error);
    EXPECT_THROW(MaugisTable({1.0, 1.0, kInfinity}), Error);
    const MaugisTable table({1.0, 1.0, 10.0});
    const MaugisDugdale law(1.0);
    for (const double odd : kOddNumbers) {
        SCOPED_TRACE(odd);
        for (const auto& state :
             {table.stable(law, odd, 1.0, 0.5), table.stable(law, 0.5, odd, 0.5),
              table.stable(law, 0.5, 1.0, odd)}) {
            EXPECT_TRUE(!state || std::isfinite(state->force));
        }
    }
    EXPECT_FALSE(table.stable(law, 0.5, kNan, 0.5));
    EXPECT_TRUE(table.stable(law, 0.5, 1.0, kNan));
}

}  // namespace
}  // namespace asperity
