#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/text/PointGrid.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

ScanChannel xyzChannel(std::string_view text) {
    const HeightMapFile file = readHeightMapBytes(text, "points.xyz");
    EXPECT_EQ(file.format, "XYZ points");
    return file.channels.at(0);
}

std::string refusalOfXyz(std::string_view text) {
    return refusalOf([&] { (void)readHeightMapBytes(text, "points.xyz"); });
}

/// Lines of points on 4 x 3 nodes with z = 10 * column + row from below.
std::vector<std::string> pointLines() {
    std::vector<std::string> lines;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            lines.push_back(std::to_string(0.5 * x) + " " + std::to_string(7 + 2 * y) + " " +
                            std::to_string(10 * x + y));
        }
    }
    return lines;
}

std::string joinedLines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

TextPoints pointsAt(const std::vector<double>& positions) {
    TextPoints points;
    for (const double position : positions) {
        points.numbers.insert(points.numbers.end(), {position, 0.0, 0.0});
    }
    return points;
}

}  // namespace

TEST(XyzReader, PointsMayStandInAnyOrder) {
    std::vector<std::string> lines = pointLines();
    std::mt19937 random(7);
    for (int turn = 0; turn < 5; ++turn) {
        const HeightMap map = xyzChannel(joinedLines(lines)).map;
        ASSERT_EQ(map.columns, 4);
        ASSERT_EQ(map.rows, 3);
        EXPECT_EQ(map.at(0, 0), 2.0);  // largest y, smallest x
        EXPECT_EQ(map.at(0, 3), 32.0);
        EXPECT_EQ(map.at(2, 1), 10.0);
        std::ranges::shuffle(lines, random);
    }
}

TEST(XyzReader, NodesMayLackTheirPoint) {
    std::vector<std::string> lines = pointLines();
    lines.erase(lines.begin() + 5);
    const ScanChannel channel = xyzChannel(joinedLines(lines));
    EXPECT_TRUE(channel.map.invalid.at(5));
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("1 of 12 nodes")));
}

TEST(XyzReader, UnitsOfTheColumnsGiveTheSize) {
    for (const char* labels :
         {"WSxM file copyright UAM\nWSxM ASCII XYZ file\nX[nm]\tY[nm]\tZ[A]\n\n",
          "# x (nm), y (nm), z (\xC3\x85)\n", "x [nm];y [nm];z [\xC5]\n"}) {
        const ScanChannel channel = xyzChannel(labels + joinedLines(pointLines()));
        EXPECT_EQ(channel.unit, "m") << labels;
        EXPECT_DOUBLE_EQ(channel.map.at(0, 3), 32e-10);
        EXPECT_DOUBLE_EQ(channel.map.sizeX(), 2e-9);
        EXPECT_DOUBLE_EQ(channel.map.sizeY(), 6e-9);
        EXPECT_DOUBLE_EQ(channel.originY, 6e-9);
    }
}

TEST(XyzReader, WithoutUnitsTheSizeIsUnknownAndTheStepsAreSaid) {
    const ScanChannel channel = xyzChannel(joinedLines(pointLines()));
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.unit, "");
    EXPECT_THAT(channel.notes, testing::Contains(AllOf(HasSubstr("0.5"), HasSubstr("2"))));
}

TEST(XyzReader, ScatteredPointsAreRefusedInWords) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> position(0.0, 1.0);
    std::string text;
    for (int i = 0; i < 200; ++i) {
        text += std::to_string(position(random)) + " " + std::to_string(position(random)) + " 1\n";
    }
    EXPECT_THAT(refusalOfXyz(text), AllOf(HasSubstr("points.xyz: "), HasSubstr("no regular grid")));
    EXPECT_THAT(refusalOfXyz("0 0 1\n1 1 1\n2 2 1\n"), HasSubstr("no regular grid"));
}

TEST(XyzReader, RefusesWhatIsNoSetOfPoints) {
    EXPECT_THAT(refusalOfXyz("0 0 1\n1 0 1\n2 0 1\n"), HasSubstr("profile"));
    EXPECT_THAT(refusalOfXyz("0 0 1\n1 0 1\n0 1 1\nNaN 1 1\n"), HasSubstr("line 4: "));
    EXPECT_THAT(refusalOfXyz("0 0 1\n1 0 1\n0 1\n"), HasSubstr("line 3: found 2 numbers"));
    std::vector<std::string> lines = pointLines();
    lines[3] = lines[4];
    EXPECT_THAT(refusalOfXyz(joinedLines(lines)), HasSubstr("two points lie at x = 0, y = 9"));
    EXPECT_THAT(refusalOfXyz("0 0 1\n1 0 1\n0 1 1\n1 1 1\n1 0 2\n"),
                HasSubstr("points.xyz: points 2 and 5: two points lie at x = 1, y = 0"));
}

TEST(PointGrid, FindsRoundedNodes) {
    std::vector<double> positions;
    for (int i = 0; i < 256; ++i) {
        positions.push_back(std::round(i * 0.01953125 * 1e4) / 1e4);
    }
    const auto axis = gridAxis(pointsAt(positions), 0);
    ASSERT_TRUE(axis);
    EXPECT_EQ(axis->count, 256);
    EXPECT_NEAR(axis->pitch, 0.01953125, 1e-6);
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(axis->nodeOf(positions[static_cast<std::size_t>(i)]), i);
    }
}

TEST(PointGrid, NodesWithoutAnyPointLieBetween) {
    const auto axis = gridAxis(pointsAt({0, 1, 2, 5, 6, 7}), 0);
    ASSERT_TRUE(axis);
    EXPECT_EQ(axis->count, 8);
    EXPECT_EQ(axis->nodeOf(5), 5);
}

TEST(PointGrid, RefusesUnequalStepsAndAbsurdPositions) {
    EXPECT_FALSE(gridAxis(pointsAt({0, 1, 2.5, 4.1}), 0));
    EXPECT_FALSE(gridAxis(pointsAt({-1e308, 1e308}), 0));
    EXPECT_EQ(gridAxis(pointsAt({3, 3}), 0)->count, 1);
}

}  // namespace asperity::test
