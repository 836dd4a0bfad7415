#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/leveling/ScarRemoval.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

/// Standard deviation of the heights [m].
double rms(const HeightMap& map) {
    const double mean = fitPlane(map).mean;
    double sum = 0.0;
    for (const double height : map.heights) {
        sum += (height - mean) * (height - mean);
    }
    return std::sqrt(sum / static_cast<double>(map.heights.size()));
}

void expectAgreement(const HeightMap& map, const test::ReferenceTable& table, std::size_t row) {
    const double scale = 1e-9;  // the table has ten digits
    const auto expectNear = [&](double value, const std::string& column, double unit) {
        const double expected = table.number(row, column);
        EXPECT_NEAR(value, expected, scale * std::max(std::abs(expected), unit)) << column;
    };
    const PlaneFit plane = fitPlane(map);
    // A slope that is nothing but rounding is told apart from the scan's own roughness.
    const double slopeUnit = 1e-6 * table.number(row, "rms_slope_x_central_difference");
    expectNear(plane.slopeX, "plane_slope_x", slopeUnit);
    expectNear(-plane.slopeY, "plane_slope_y_down", slopeUnit);
    expectNear(rms(map), "rms_raw", 0.0);
    expectNear(rms(leveled(map, {LevelingStep::Plane})), "rms_after_plane", 0.0);
    expectNear(rms(leveled(map, {LevelingStep::Rows})), "rms_after_row_median", 0.0);
    expectNear(rms(leveled(map, {LevelingStep::MedianOfDifferences})),
               "rms_after_median_of_differences_keep_y_trend", 0.0);
    // Without the trend: no step of a scene, since it makes up a slope.
    HeightMap untrended = map;
    subtractRows(untrended, differenceShifts(map));
    expectNear(rms(untrended), "rms_after_median_of_differences", 0.0);
}

TEST(Leveling, OfRealScansAgreesWithTheGroundTruth) {
    ASPERITY_NEEDS_SHARED_DATA();
    const test::ReferenceTable table(test::sharedData("afm/LEVELLING.csv"));
    int checked = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::filesystem::path path = test::sharedData("afm/" + table.text(row, "file"));
        SCOPED_TRACE(path.string());
        HeightMapFile file;
        try {
            file = readHeightMapFile(path);
        } catch (const InputError&) {
            continue;  // a format without a native reader; its own tests say so
        }
        expectAgreement(heightChannel(file, path, table.text(row, "channel")).map, table, row);
        ++checked;
    }
    EXPECT_GE(checked, 3);
}

}  // namespace
}  // namespace asperity
