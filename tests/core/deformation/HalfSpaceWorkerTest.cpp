#include "core/Units.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <memory>
#include <thread>

namespace asperity {
namespace {

class HalfSpaceWorkerOnAFlatSample : public ::testing::Test {
protected:
    [[nodiscard]] TipState bondedAt(double x) const {
        EquilibriumMemory memory;
        TipState state;
        for (int step = 0; step < 60; ++step) {
            const double height = 3.0_nm - step * 0.05_nm;
            state = tipEquilibrium(scene.surface, scene.belief, {.position = {x, 64.0_nm, height}},
                                   memory);
        }
        return state;
    }
    /// The answer to a state, once there is one; null after ten seconds.
    static std::shared_ptr<const HalfSpaceAnswer> answerFor(const HalfSpaceWorker& worker,
                                                            const TipState& state) {
        for (int i = 0; i < 10000; ++i) {
            auto answer = worker.newest();
            if (answer && answer->state.tip == state.tip) {
                return answer;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return nullptr;
    }

    Scene scene = buildScene(test::plainScene(), test::flatMap());
};

TEST_F(HalfSpaceWorkerOnAFlatSample, AnswersTheNewestQuestion) {
    HalfSpaceWorker worker(scene);
    EXPECT_EQ(worker.newest(), nullptr);
    TipState last;
    for (const double x : {50.0_nm, 55.0_nm, 60.0_nm, 64.0_nm}) {
        last = bondedAt(x);
        worker.ask(last);
    }
    const auto answer = answerFor(worker, last);
    ASSERT_NE(answer, nullptr);
    EXPECT_TRUE(answer->valid()) << nameOf(answer->verdict);
    EXPECT_NE(answer->field, nullptr);
    EXPECT_TRUE(stillHolds(*answer, last));
}

TEST_F(HalfSpaceWorkerOnAFlatSample, EndsWhileItSolves) {
    for (int i = 0; i < 20; ++i) {
        HalfSpaceWorker worker(scene);
        worker.ask(bondedAt(50.0_nm + i * 1.0_nm));
    }
    HalfSpaceWorker idle(scene);  // and while it waits
}

TEST_F(HalfSpaceWorkerOnAFlatSample, SurvivesWhatCannotBeSolved) {
    HalfSpaceWorker worker(scene);
    TipState state = bondedAt(64.0_nm);
    state.contact.indentation = std::numeric_limits<double>::infinity();
    worker.ask(state);
    const auto answer = answerFor(worker, state);
    ASSERT_NE(answer, nullptr);
    EXPECT_FALSE(answer->valid());
}

}  // namespace
}  // namespace asperity
