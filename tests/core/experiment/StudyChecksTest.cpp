#include "core/Units.h"
#include "core/experiment/Study.h"
#include "core/scene/Scene.h"
#include "tests/core/experiment/SmallStudy.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace asperity::test {
namespace {

/// The key that a study is refused by; empty: it is not.
std::string refusedKey(const Study& study) {
    try {
        checkStudy(study);
    } catch (const StudyRefused& refused) {
        return refused.key;
    }
    return {};
}

std::string refusedKeyOnItsScenes(const Study& study) {
    std::vector<Scene> scenes;
    for (std::size_t material = 0; material < study.materials.size(); ++material) {
        scenes.push_back(buildScene(sceneOf(study, material, 0)));
    }
    try {
        checkStudyOn(study, {}, [&](std::size_t material, std::size_t /*lever*/) -> const Scene& {
            return scenes[material];
        });
    } catch (const StudyRefused& refused) {
        return refused.key;
    }
    return {};
}

Study with(const std::function<void(Study&)>& change) {
    Study study = smallStudy();
    change(study);
    return study;
}

TEST(StudyChecks, AcceptsTheStudyOfThePaper) {
    EXPECT_EQ(refusedKey(smallStudy()), "");
    EXPECT_EQ(refusedKeyOnItsScenes(smallStudy()), "");
}

TEST(StudyChecks, NamesTheKeyThatCannotBe) {
    EXPECT_EQ(refusedKey(with([](Study& s) { s.materials.clear(); })), "material");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.levers.clear(); })), "lever");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.tasks.clear(); })), "task");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.targets.clear(); })), "targets_m");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.repeats = 0; })), "repeats");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.timeLimit = 0.0; })), "time_limit_s");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.training = -1.0; })), "training_s");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.startHeight = 0.0; })), "start_height_m");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.tasks[0].nearest = 0.0; })), "task 1: nearest_m");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.tasks[0].farthest = 1.0_nm; })),
              "task 1: farthest_m");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.tasks[1].nearest = 1.0_nm; })), "task 2: nearest_m");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.tasks[2].materials.clear(); })),
              "task 3: materials");
    EXPECT_EQ(refusedKey(with([](Study& s) { s.tasks[2].materials = {7}; })), "task 3: materials");
}

TEST(StudyChecks, RefusesToPressIntoOxide) {
    EXPECT_EQ(refusedKeyOnItsScenes(with([](Study& s) { s.tasks[2].materials = {0}; })),
              "task 3: materials");
}

TEST(StudyChecks, RefusesTargetsOutOfScanAndOutOfReach) {
    EXPECT_EQ(refusedKeyOnItsScenes(with([](Study& s) {
                  s.targets[1] = {210.0_nm, 0.0};
              })),
              "targets_m: target 2");
    EXPECT_EQ(refusedKeyOnItsScenes(with([](Study& s) {
                  s.targets[0] = {80.0_nm, 0.0};
              })),
              "targets_m: target 1");
}

TEST(StudyChecks, RefusesAGainThatTheDeviceCannotHold) {
    EXPECT_EQ(refusedKeyOnItsScenes(with([](Study& s) { s.scale.forceGain = 1e10; })),
              "scale: force_gain");
}

}  // namespace
}  // namespace asperity::test
