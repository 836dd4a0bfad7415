#include "app/reports/RunPictures.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

namespace asperity::test {
namespace {

/// A run that indents a flat sample and pulls off.
struct ContactViewTest : ::testing::Test {
    ContactViewTest() {
        const PathPlan plan{.duration = 4.0, .slideLength = 0.0};
        SimulatedAfm afm(scene.surface, truthOf(scene));
        runVirtually(scene, slidePath(scene, plan), afm, 4000, [this](const TickSample& sample) {
            recorder.take(sample);
            away = away ? away : sample;
        });
    }

    [[nodiscard]] std::string captionOf(const TickSample& sample) const {
        return contactView(scene, sample, "title").caption;
    }

    const Scene scene = buildScene(plainScene(), flatMap());
    RunEventRecorder recorder;
    std::optional<TickSample> away;
};

/// "Indentation -57.4 pm" was said of a surface that was pulled up.
TEST_F(ContactViewTest, TheDistanceIsCalledAsItsStateIs) {
    EXPECT_TRUE(captionOf(*away).starts_with("Gap ")) << captionOf(*away);
    const std::string deep = captionOf(recorder.events().deepest.value());
    EXPECT_TRUE(deep.starts_with("Indentation ")) << deep;
    const std::string neck = captionOf(recorder.events().beforePullOff.value());
    EXPECT_TRUE(neck.starts_with("Neck height ")) << neck;
    for (const std::string& caption : {captionOf(*away), deep, neck}) {
        EXPECT_EQ(caption.substr(0, caption.find(',')).find('-'), std::string::npos) << caption;
    }
}

/// It began deep in the block, and the dent was a speck.
TEST_F(ContactViewTest, ShowsTheContactLargeAndTheForceOnTheDeformedSurface) {
    const TickSample deep = recorder.events().deepest.value();
    const DeformationView view = contactView(scene, deep, "title");
    const double halfWidth = zoomGrid(scene, deep).halfWidth;
    EXPECT_GE(halfWidth, 4.0 * view.contactRadius);
    EXPECT_LE(halfWidth, std::max(4.0 * view.contactRadius, view.tipRadius));
    const std::size_t middle = view.patch.index(view.patch.rows / 2, view.patch.columns / 2);
    EXPECT_LT((view.contactPoint - view.patch.points[middle]).norm(), 0.02 * view.contactRadius);
    EXPECT_LT(view.contactPoint.z(), view.patch.rest[middle].z());
}

/// A tip of 2 um showed 200 nm at least, and the contact of some nanometers was a speck.
TEST_F(ContactViewTest, UnderABluntTipItShowsTheAsperity) {
    SceneDescription description = plainScene();
    description.tip.radius = 2e-6;
    const Scene blunt = buildScene(description, hillyMap());
    TickSample sample = recorder.events().deepest.value();
    sample.output.model.effectiveRadius = 15e-9;
    sample.output.model.contact.contactRadius = 3e-9;
    sample.output.model.contact.indentation = 0.2e-9;
    EXPECT_LT(zoomGrid(blunt, sample).halfWidth, 20e-9);
    EXPECT_GE(zoomGrid(blunt, sample).halfWidth, 12e-9);
}

}  // namespace
}  // namespace asperity::test
