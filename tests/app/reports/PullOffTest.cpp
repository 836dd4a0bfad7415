#include "app/loading/SceneLoader.h"
#include "core/Error.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asperity {
namespace {

using Paths = std::vector<std::filesystem::path>;

/// All files below a folder, in the order of their names.
Paths filesBelow(const std::filesystem::path& folder) {
    Paths files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// As `asperity explore` runs it.
RunEvents explored(const Scene& scene) {
    const PathPlan plan;
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    RunEventRecorder recorder;
    runVirtually(scene, slidePath(scene, plan), afm,
                 std::lround(plan.duration / scene.timeStep()) + 1,
                 [&](const TickSample& sample) { recorder.take(sample); });
    return recorder.events();
}

/// The picture of the pull-off is of a moment in which signals and model both hold the tip.
void expectBothHold(const LoadedScene& loaded) {
    const RunEvents events = explored(loaded.scene);
    ASSERT_TRUE(events.lastHold);
    EXPECT_LE(events.lastHold->time, events.beforePullOff->time);
    const TickOutput& out = events.lastHold->output;
    const Vector3& normal = out.model.normal;
    const double estimate = out.estimate.force.dot(normal);
    const double sigma = std::sqrt(normal.dot(out.estimate.covariance * normal));
    EXPECT_EQ(out.model.contact.branch, ContactBranch::Bonded);
    EXPECT_LT(out.model.normalForce, 0.0);
    EXPECT_LT(estimate, 0.0);
    EXPECT_NEAR(estimate, out.model.normalForce,
                std::max(3.0 * sigma, 0.2 * std::abs(out.model.normalForce)));
    EXPECT_FALSE(out.flags.has(Validity::ModelContradicted));
}

/// Nothing where the file is no height map that can be read.
std::optional<LoadedScene> readable(const std::filesystem::path& input) {
    try {
        return loadScene(input, {});
    } catch (const InputError&) {
        return std::nullopt;
    }
}

TEST(PullOff, OfEveryShippedSceneIsWhereSignalsAndModelHoldTheTip) {
    int scenes = 0;
    for (const auto& file : filesBelow(test::dataFolder() / "scenes")) {
        SCOPED_TRACE(file.filename());
        expectBothHold(loadScene(file, {}));
        ++scenes;
    }
    EXPECT_GE(scenes, 5);
}

TEST(PullOff, OfARealScanOfEachFormatIsWhereSignalsAndModelHoldTheTip) {
    ASPERITY_NEEDS_SHARED_DATA();
    std::set<std::string> formats;
    for (const auto& file : filesBelow(test::sharedData("afm"))) {
        if (formats.contains(file.extension())) {
            continue;
        }
        if (const std::optional<LoadedScene> loaded = readable(file)) {
            SCOPED_TRACE(file.filename());
            expectBothHold(*loaded);
            formats.insert(file.extension());
        }
    }
    EXPECT_GE(formats.size(), 7U);
}

TEST(PullOffLong, OfEveryRealScanIsWhereSignalsAndModelHoldTheTip) {
    ASPERITY_NEEDS_SHARED_DATA();
    int scans = 0;
    for (const auto& file : filesBelow(test::sharedData("afm"))) {
        if (const std::optional<LoadedScene> loaded = readable(file)) {
            SCOPED_TRACE(file.filename());
            expectBothHold(*loaded);
            ++scans;
        }
    }
    EXPECT_GE(scans, 7);
}

}  // namespace
}  // namespace asperity
