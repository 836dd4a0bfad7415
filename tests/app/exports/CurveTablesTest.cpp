#include "app/exports/CurveTables.h"

#include "app/loading/SceneLoader.h"
#include "app/reports/RunPictures.h"
#include "core/haptics/SetpointApproach.h"
#include "core/io/tables/CsvTable.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace asperity {
namespace {

class CurveTables : public ::testing::Test {
protected:
    CurveTables() {
        const Scene& scene = loaded.scene;
        ApproachDevice device(planApproach(scene, {.duration = 1.0}), scene.settings.positionGain);
        RunInputs recorded(TickMemory{});
        runVirtually(scene, device, *instrumentOf(scene), 1001, [&](const TickSample& sample) {
            expected.push_back(sample);
            recorded.add(sample);
        });
        run.emplace(scene, std::move(recorded));
    }

    const LoadedScene loaded = loadScene(test::shippedScene("polystyrene"), {});
    std::vector<TickSample> expected;
    std::optional<RunPlayback> run;
    test::ScratchFolder folder;
};

TEST_F(CurveTables, HoldForcesToTheBit) {
    writeForcesTable(folder.path() / "forces.csv", *run, nullptr);
    const CsvTable table = readCsv(folder.path() / "forces.csv");
    ASSERT_EQ(table.rows(), expected.size());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const TickOutput& out = expected[row].output;
        ASSERT_EQ(table.number(row, "time_s"), expected[row].time);
        ASSERT_EQ(table.number(row, "force_z_n"), out.estimate.force.z());
        ASSERT_EQ(table.number(row, "model_force_x_n"), out.model.force.x());
        ASSERT_EQ(table.number(row, "indentation_m"), out.model.contact.indentation);
        ASSERT_EQ(table.number(row, "torsion_rad"),
                  expected[row].input.measurement.signals.torsion);
    }
}

TEST_F(CurveTables, OfTicksAtHandAreThoseOfTheRun) {
    writeForcesTable(folder.path() / "run.csv", *run, nullptr);
    writeForcesTable(folder.path() / "ticks.csv", expected);
    EXPECT_EQ(test::contentOf(folder.path() / "run.csv"),
              test::contentOf(folder.path() / "ticks.csv"));
}

TEST_F(CurveTables, HoldCurvesOneBelowAnotherWithoutTheirGaps) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Curve> curves{
        {.label = "approach", .x = {1e-9, 2e-9, 3e-9}, .y = {0.1e-9, gap, 0.3e-9}},
        {.label = "retract, 1 before", .x = {5e-9}, .y = {-0.7e-9}}};
    writeForceCurvesTable(folder.path() / "curves.csv", curves, "separation_m");
    const CsvTable table = readCsv(folder.path() / "curves.csv");
    ASSERT_EQ(table.rows(), 3U);
    EXPECT_EQ(table.text(1, "curve"), "approach");
    EXPECT_EQ(table.number(1, "separation_m"), 3e-9);
    EXPECT_EQ(table.text(2, "curve"), "retract, 1 before");
    EXPECT_EQ(table.number(2, "force_n"), -0.7e-9);
}

TEST_F(CurveTables, HoldACycleToTheBit) {
    const std::vector<CyclePoint> cycle = cycleAround(*run, 500, nullptr);
    writeCycleTable(folder.path() / "cycle.csv", cycle);
    const CsvTable table = readCsv(folder.path() / "cycle.csv");
    ASSERT_EQ(table.rows(), cycle.size());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        ASSERT_EQ(table.number(row, "separation_m"), cycle[row].point.separation);
        ASSERT_EQ(table.number(row, "force_n"), cycle[row].point.force);
        ASSERT_EQ(table.text(row, "branch"), keyOf(cycle[row].branch));
    }
}

TEST_F(CurveTables, HoldAPatchToTheBit) {
    const SurfacePatch patch = zoomPatch(loaded.scene, expected[500]);
    writePatchTable(folder.path() / "patch.csv", patch);
    const CsvTable table = readCsv(folder.path() / "patch.csv");
    ASSERT_EQ(table.rows(), patch.points.size());
    for (std::size_t row = 0; row < table.rows(); row += 97) {
        ASSERT_EQ(table.number(row, "rest_x_m"), patch.rest[row].x());
        ASSERT_EQ(table.number(row, "displacement_z_m"),
                  patch.points[row].z() - patch.rest[row].z());
        ASSERT_EQ(table.number(row, "normal_z"), patch.normals[row].z());
    }
}

}  // namespace
}  // namespace asperity
