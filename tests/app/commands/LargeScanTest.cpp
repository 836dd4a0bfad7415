#include "core/Units.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/surface/HeightMap.h"
#include "tests/app/ChildProgram.h"
#include "tests/app/TracedProgram.h"
#include "tests/support/Places.h"
#include "tests/support/Sanitized.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// Hills with a tenth of the rows without data, as large as asked for, never in memory.
HeightRows largeHills(int side) {
    return {.columns = side,
            .rows = side,
            .pitchX = 2.0_nm,
            .pitchY = 2.0_nm,
            .readRow = [side](int row, double* heights) {
                for (int column = 0; column < side; ++column) {
                    heights[column] =
                        row % 10 == 5 ? std::numeric_limits<double>::quiet_NaN()
                                      : 20.0_nm * std::sin(column / 90.0) * std::sin(row / 70.0);
                }
            }};
}

class LargeScan : public ::testing::Test {
protected:
    /// Returns the memory of `asperity` with these arguments, IN being a scan of this side [bytes].
    [[nodiscard]] long peakMemory(int side, std::vector<std::string> arguments) const {
        writeHeightMap(input, largeHills(side), {});
        std::ranges::replace(arguments, std::string("IN"), input.string());
        const test::ChildEnd end = test::ChildProgram(arguments).wait();
        EXPECT_EQ(end.exitCode, 0) << arguments.at(0) << ' ' << side;
        return end.peakMemory;
    }

    /// Returns the memory that a scan adds, in parts of its float32 size.
    [[nodiscard]] double share(const std::vector<std::string>& arguments) const {
        constexpr int kSmall = 16;
        constexpr int kLarge = 3000;
        const auto added = peakMemory(kLarge, arguments) - peakMemory(kSmall, arguments);
        return static_cast<double>(added) / (4.0 * kLarge * kLarge);
    }

    test::ScratchFolder scratch;
    std::filesystem::path input = scratch.file("in.gsf");
};

TEST_F(LargeScan, TakesAtMostTwoAndAHalfTimesItsSize) {
    if (test::kSanitized) {
        GTEST_SKIP() << "the memory of a sanitizer is not that of the program";
    }
    const std::filesystem::path scene = scratch.write(
        "scene.toml", "[sample]\nfile = \"in.gsf\"\nimaging_tip_radius_m = 20e-9\nerode = true\n");
    const std::string points =
        scratch.write("points.csv", "x_m,y_m,z_m\n1e-8,1e-8,1e-7\n").string();
    const std::string out = scratch.file("out").string();
    EXPECT_LE(share({"project", "IN", "--points", points, "--out", out}), 2.5);
    EXPECT_LE(share({"project", scene.string(), "--points", points, "--out", out}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".gsf", "--level", "plane"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".gwy"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".exr"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".png"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".vti"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".tif", "--bits", "16"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".gwy", "--all"}), 0.1);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".stl"}), 2.5);
    EXPECT_LE(share({"convert", "--force", "IN", out + ".tiff", "--erode", "20e-9", "--certainty",
                     out + ".gsf"}),
              2.5);
    EXPECT_LE(share({"map", "--force", "IN", "--out", out + "_map.gwy", "--grid", "1000x1",
                     "--no-pictures"}),
              2.5);
}

TEST_F(LargeScan, IsLookedAtRowByRow) {
    if (test::kSanitized) {
        GTEST_SKIP() << "the memory of a sanitizer is not that of the program";
    }
    EXPECT_LE(share({"info", "IN"}), 0.1);
    EXPECT_LE(share({"info", "IN", "--json"}), 0.1);
}

TEST_F(LargeScan, ASignalEndsConvertAndNothingIsLeft) {
    writeHeightMap(input, largeHills(3000), {});
    const std::filesystem::path folder = scratch.file("results");
    std::filesystem::create_directory(folder);
    for (const auto& [signal, name] :
         {std::pair{SIGINT, "out.txt"}, {SIGTERM, "out.txt"}, {SIGINT, "out.stl"}}) {
        const test::TracedEnd end =
            test::runTraced({test::programOfBuild("asperity").string(), "convert", input.string(),
                             (folder / name).string()},
                            {}, {.bytes = 100'000, .signal = signal});
        EXPECT_TRUE(end.wasSignaled);
        EXPECT_EQ(end.exitCode, 1);
        EXPECT_TRUE(std::filesystem::is_empty(folder));
    }
}

}  // namespace
}  // namespace asperity
