#include "core/fidelity/RequiredTerms.h"
#include "core/fidelity/SampledRuns.h"
#include "core/scene/BelievedModel.h"
#include "tests/core/fidelity/RandomScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace asperity {
namespace {

const TermNeed& needOf(const RequiredTerms& needs, ModelTerm term) {
    return needs.terms.at(static_cast<std::size_t>(term));
}

/// Terms of the force that the runs decide about.
bool isDecidedByRuns(const RequiredTerms& needs, ModelTerm term) {
    return !isOfSurface(term) && has(needs.full, term) && !needOf(needs, term).overruled;
}

/// The search for closest points also stays by a bound, without any effect on the runs.
bool mayStayWithoutEffect(ModelTerm term) { return term == ModelTerm::GlobalSearch; }

void expectSurfaceDecided(const RequiredTerms& needs) {
    const TermNeed& outside = needOf(needs, ModelTerm::OutsideDisplacement);
    const TermNeed& halfSpace = needOf(needs, ModelTerm::HalfSpaceSolve);
    EXPECT_TRUE(outside.on || outside.effect <= needs.tolerance);
    EXPECT_TRUE(!halfSpace.on || halfSpace.effect > needs.tolerance);
    EXPECT_TRUE(!halfSpace.on || outside.on) << "it shares its displacement";
}

/// By how much what is left out moves the force at positions that the decision did not look at.
double movedElsewhere(Scene& scene, const RequiredTerms& needs) {
    setModel(scene, needs.full);
    const std::vector<ModelInputs> runs = test::runsElsewhere(scene);
    const ModelRun whole = runModel(scene, runs);
    setModel(scene, needs.model);
    return forceShare(runModel(scene, runs).states, whole.states);
}

void expectKeepWhatMovesTheForce(unsigned seed, int scenes) {
    Random random(seed);
    int kept = 0;
    int leftOut = 0;
    int alsoElsewhere = 0;
    for (int i = 0; i < scenes; ++i) {
        SCOPED_TRACE(i);
        Scene scene = test::randomScene(random);
        const RequiredTerms needs = fitModel(scene);
        ASSERT_EQ(needs.terms.size(), kModelTerms.size());
        alsoElsewhere += movedElsewhere(scene, needs) <= needs.tolerance ? 1 : 0;
        setModel(scene, needs.full);
        SampledRuns runs(scene, 1.0);
        const auto worstOf = [&](const ForceModelOptions& model) {
            return runs.errors(model, needs.full).worst();
        };
        EXPECT_LE(worstOf(needs.model), needs.tolerance) << "all that is left out together";
        expectSurfaceDecided(needs);
        for (const ModelTerm term : kModelTerms) {
            if (!isDecidedByRuns(needs, term)) {
                continue;
            }
            if (has(needs.model, term)) {
                ++kept;
                const double alone = worstOf(without(needs.full, term));
                EXPECT_DOUBLE_EQ(needOf(needs, term).effect, alone) << nameOf(term);
                EXPECT_TRUE(std::max(alone, worstOf(without(needs.model, term))) >
                                needs.tolerance ||
                            mayStayWithoutEffect(term))
                    << nameOf(term) << " was kept";
            } else {
                ++leftOut;
                EXPECT_LE(worstOf(without(needs.full, term)), needs.tolerance)
                    << nameOf(term) << " was left out";
            }
        }
    }
    EXPECT_GE(alsoElsewhere, scenes * 4 / 5) << "scenes where it holds at places not looked at";
    EXPECT_GT(kept, scenes);
    EXPECT_GT(leftOut, scenes);
}

class RandomRequiredTerms : public ::testing::TestWithParam<unsigned> {};
class RandomRequiredTermsLong : public RandomRequiredTerms {};

TEST_P(RandomRequiredTerms, KeepWhatMovesTheForceAndLeaveOutWhatDoesNot) {
    expectKeepWhatMovesTheForce(GetParam(), 5);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomRequiredTerms, ::testing::Values(20261122U, 1U));

TEST_P(RandomRequiredTermsLong, KeepWhatMovesTheForceAndLeaveOutWhatDoesNot) {
    expectKeepWhatMovesTheForce(GetParam(), 50);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomRequiredTermsLong, ::testing::Values(20261122U, 1U, 2U, 3U));

TEST(RandomScenes, TwiceTheSame) {
    Random first(3);
    Random second(3);
    Scene one = test::randomScene(first);
    Scene other = test::randomScene(second);
    const RequiredTerms a = fitModel(one);
    const RequiredTerms b = fitModel(other);
    EXPECT_EQ(a.modelErrors, b.modelErrors);
    for (std::size_t i = 0; i < a.terms.size(); ++i) {
        EXPECT_EQ(a.terms[i].on, b.terms[i].on) << nameOf(a.terms[i].term);
        EXPECT_EQ(a.terms[i].effect, b.terms[i].effect) << nameOf(a.terms[i].term);
        EXPECT_EQ(a.terms[i].fact, b.terms[i].fact);
    }
}

void expectSettledGivesTheSameAgain(int scenes) {
    Random random(11);
    for (int i = 0; i < scenes; ++i) {
        Scene scene = test::randomScene(random);
        (void)fitModel(scene);
        const ForceModelOptions found = scene.model;
        scene.description = settled(scene.description, found);
        (void)fitModel(scene);
        EXPECT_EQ(scene.model.law, found.law);
        for (const ModelTerm term : kModelTerms) {
            EXPECT_EQ(has(scene.model, term), has(found, term)) << nameOf(term);
        }
    }
}

TEST(RandomScenes, TheSettledDescriptionGivesTheSameModelAgain) {
    expectSettledGivesTheSameAgain(3);
}

TEST(RandomScenesLong, TheSettledDescriptionGivesTheSameModelAgain) {
    expectSettledGivesTheSameAgain(20);
}

TEST(RandomScenes, AWiderToleranceLeavesOutNoLess) {
    Random random(5);
    for (int i = 0; i < 5; ++i) {
        Scene scene = test::randomScene(random);
        const auto count = [&](double tolerance) {
            scene.description.tolerance = tolerance;
            const RequiredTerms needs = fitModel(scene);
            return std::ranges::count_if(needs.terms, &TermNeed::on);
        };
        EXPECT_GE(count(0.0), count(0.5));
    }
}

}  // namespace
}  // namespace asperity
