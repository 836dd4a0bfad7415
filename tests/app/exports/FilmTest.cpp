#include "app/exports/Film.h"

#include "app/exports/CurveTables.h"
#include "app/exports/RunMoment.h"
#include "app/exports/VideoFile.h"
#include "app/loading/SceneLoader.h"
#include "core/Error.h"
#include "core/haptics/SetpointApproach.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// An approach to contact and a retract, 2 s.
class RecordedApproach : public ::testing::Test {
protected:
    RecordedApproach() : run(loaded.scene, recorded(loaded.scene)) {}

    static RunInputs recorded(const Scene& scene) {
        RunInputs run(TickMemory{});
        const PlannedApproach plan = planApproach(scene, {.duration = 2.0});
        ApproachDevice device(plan, scene.settings.positionGain);
        runVirtually(scene, device, *instrumentOf(scene), 2001,
                     [&run](const TickSample& sample) { run.add(sample); });
        return run;
    }

    [[nodiscard]] std::string refusalOf(const RunMoment& moment) {
        try {
            (void)tickOf(run, moment);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    const LoadedScene loaded = loadScene(test::shippedScene("polystyrene"), {});
    RunPlayback run;
};

using RunMoments = RecordedApproach;

TEST_F(RunMoments, AreFoundByTheirWords) {
    const std::size_t deepest = tickOf(run, NamedMoment::Deepest);
    const double indentation = run.at(deepest).output.model.contact.indentation;
    for (std::size_t tick = 0; tick < run.size(); ++tick) {
        ASSERT_LE(run.at(tick).output.model.contact.indentation, indentation) << tick;
    }
    const std::size_t snapIn = tickOf(run, NamedMoment::SnapIn);
    EXPECT_EQ(run.at(snapIn).output.model.contact.branch, ContactBranch::Bonded);
    EXPECT_EQ(run.at(snapIn - 1).output.model.contact.branch, ContactBranch::Far);
    const std::size_t pullOff = tickOf(run, NamedMoment::PullOff);
    EXPECT_GT(pullOff, deepest);
    EXPECT_EQ(run.at(pullOff).output.model.contact.branch, ContactBranch::Bonded);
    EXPECT_LT(run.at(pullOff).output.model.normalForce, 0.0);
    EXPECT_EQ(tickOf(run, NamedMoment::Start), 0U);
    EXPECT_EQ(tickOf(run, NamedMoment::End), 2000U);
    EXPECT_EQ(tickOf(run, 1.25), 1250U);
}

TEST_F(RunMoments, OutsideOfTheRunAreRefusedWithItsRange) {
    for (const double time : {-0.001, 2.001, 1e9}) {
        EXPECT_NE(refusalOf(time).find("it goes from 0 s to 2 s"), std::string::npos) << time;
    }
}

TEST(RunMoment, IsAWordOrATime) {
    EXPECT_EQ(std::get<NamedMoment>(runMoment("pull-off")), NamedMoment::PullOff);
    EXPECT_EQ(std::get<double>(runMoment("0.5")), 0.5);
    for (const char* bad : {"", "nan", "inf", "5s", "Deepest", "1,5"}) {
        EXPECT_THROW((void)runMoment(bad), Error) << bad;
    }
}

using FilmTicks = RecordedApproach;

TEST_F(FilmTicks, SpreadEvenlyOverThePart) {
    const std::vector<std::size_t> whole = filmTicks(run, {.spec = {}});
    ASSERT_EQ(whole.size(), 50U);
    EXPECT_EQ(whole.front(), 0U);
    EXPECT_EQ(whole.back(), 2000U);
    const std::vector<std::size_t> part =
        filmTicks(run, {.from = 0.5, .to = 1.5, .fps = 10.0, .duration = 3.1, .spec = {}});
    ASSERT_EQ(part.size(), 31U);
    EXPECT_EQ(part.front(), 500U);
    EXPECT_EQ(part[15], 1000U);
    EXPECT_EQ(part.back(), 1500U);
    EXPECT_EQ(filmTicks(run, {.speed = 2.0, .spec = {}}).size(), 25U);
}

TEST_F(FilmTicks, RefuseAPartWithoutLengthAndAnEndlessFilm) {
    EXPECT_THROW((void)filmTicks(run, {.from = 1.0, .to = 1.0, .spec = {}}), Error);
    EXPECT_THROW((void)filmTicks(run, {.from = NamedMoment::End, .to = 1.0, .spec = {}}), Error);
    EXPECT_THROW((void)filmTicks(run, {.duration = 1e9, .spec = {}}), Error);
    EXPECT_THROW((void)filmTicks(run, {.view = ExportView::Forces, .spec = {}}), Error);
}

using CycleAround = RecordedApproach;

TEST_F(CycleAround, HoldsItsTicksOnce) {
    const std::vector<CyclePoint> cycle = cycleAround(run, 1000, nullptr);
    ASSERT_FALSE(cycle.empty());
    bool approaches = false;
    bool retracts = false;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        approaches = approaches || cycle[i].branch == CurveBranch::Approach;
        retracts = retracts || cycle[i].branch == CurveBranch::Retract;
        if (i > 0) {
            ASSERT_GT(cycle[i].time, cycle[i - 1].time);
        }
    }
    EXPECT_TRUE(approaches && retracts);
}

TEST_F(CycleAround, IsDrawnWithTheMomentOnItsCurve) {
    const std::vector<CyclePoint> cycle = cycleAround(run, 1000, nullptr);
    const Chart chart = cycleChart(cycle, run.at(1000));
    ASSERT_EQ(chart.curves.size(), 3U);
    const ForceDistancePoint point = forceDistancePoint(run.at(1000).output);
    EXPECT_EQ(chart.curves[2].x.front(), point.separation);
    EXPECT_EQ(chart.curves[2].y.front(), point.force);
}

using Captions = RecordedApproach;

TEST_F(Captions, SayTheStateAndKeepTheirUnits) {
    MomentCaption caption;
    const std::size_t deepest = tickOf(run, NamedMoment::Deepest);
    for (const std::size_t tick : {std::size_t{0}, deepest}) {
        caption.take(run.at(tick));
    }
    const std::string far = caption.of(run.at(0));
    EXPECT_NE(far.find("t = 0.000 s, normal force "), std::string::npos) << far;
    EXPECT_NE(far.find(", gap "), std::string::npos) << far;
    EXPECT_NE(far.find(" nN"), std::string::npos) << far;
    EXPECT_TRUE(far.ends_with(", far")) << far;
    const std::string indented = caption.of(run.at(deepest));
    EXPECT_NE(indented.find(", indentation "), std::string::npos) << indented;
    EXPECT_TRUE(indented.ends_with(", in contact")) << indented;
}

TEST(VideoFile, WithoutItsProgramIsRefusedInOneSentence) {
    const test::ScratchFolder folder;
    const std::string path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    setenv("PATH", folder.path().c_str(), 1);      // NOLINT(concurrency-mt-unsafe)
    try {
        const VideoFile video(folder.path() / "a.mp4", {.width = 64, .height = 64}, 25.0);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("ffmpeg, which was not found"), std::string::npos);
    }
    setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// A program of this name that ends with an error.
TEST(VideoFile, SaysWhatItsProgramComplainsOf) {
    const test::ScratchFolder folder;
    const auto program = folder.write("ffmpeg", "#!/bin/sh\necho no such codec >&2\nexit 1\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const std::string path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);  // NOLINT
    const auto target = folder.path() / "a.mp4";
    std::string said;
    try {
        VideoFile video(target, {.width = 64, .height = 64}, 25.0);
        const RasterImage frame{.width = 64,
                                .height = 64,
                                .pixels = std::vector<std::uint8_t>(std::size_t{64} * 64 * 4)};
        for (int i = 0; i < 100; ++i) {
            video.add(frame, nullptr);
        }
        video.commit(nullptr);
    } catch (const Error& error) {
        said = error.what();
    }
    setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_NE(said.find("no such codec"), std::string::npos) << said;
    EXPECT_FALSE(std::filesystem::exists(target));
}

/// A program of this name that reads nothing and does not end.
TEST(VideoFile, AProgramThatHangsCanBeGivenUp) {
    const test::ScratchFolder folder;
    const auto program = folder.write("ffmpeg", "#!/bin/sh\nexec sleep 600\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const std::string path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);  // NOLINT
    const auto target = folder.path() / "a.mp4";
    {
        VideoFile video(target, {.width = 640, .height = 480}, 25.0);
        const RasterImage frame{.width = 640,
                                .height = 480,
                                .pixels = std::vector<std::uint8_t>(std::size_t{640} * 480 * 4)};
        const test::CanceledAfter progress(0);
        EXPECT_THROW(
            {
                for (int i = 0; i < 100; ++i) {
                    video.add(frame, &progress);
                }
            },
            Canceled);
        const test::CanceledAfter ending(0);
        EXPECT_THROW(video.commit(&ending), Canceled);
    }
    setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_FALSE(std::filesystem::exists(target));
}

}  // namespace
}  // namespace asperity
