#include "core/Units.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace asperity {
namespace {

/// Particles of 10 nm as a tip of 15 nm records them; one row without data.
HeightMap recordedParticles() {
    const ScanSize size{.columns = 96, .rows = 80, .sizeX = 192.0_nm, .sizeY = 160.0_nm};
    const Nanoparticles shape({.count = 3,
                               .medianRadius = 10.0_nm,
                               .smallest = 9.0_nm,
                               .largest = 11.0_nm,
                               .scanTipRadius = 15.0_nm},
                              size);
    HeightMap map = sampledMap(size, shape);
    for (int column = 0; column < map.columns; ++column) {
        map.heights[map.index(79, column)] = std::numeric_limits<double>::quiet_NaN();
    }
    return map;
}

const HeightMap& mapOf(const HeightMapFile& file) {
    return file.channels.at(file.defaultChannel).map;
}

class ConvertErosion : public ::testing::Test {
protected:
    void SetUp() override { writeHeightMap(input, recordedParticles(), {}); }

    [[nodiscard]] test::ProgramRun convert(const std::string& options) const {
        return test::runProgram("convert " + input.string() + " " + output.string() + options);
    }

    test::ScratchFolder scratch;
    std::filesystem::path input = scratch.file("in.gwy");
    std::filesystem::path output = scratch.file("out.gwy");
    std::filesystem::path map = scratch.file("certain.gsf");
};

TEST_F(ConvertErosion, TakesTheTipOutAndWritesWhereThatIsCertain) {
    const auto run = convert(" --erode 15e-9 --certainty " + map.string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const ScanReconstruction expected = reconstructed(readHeightScan(input, "").map, 15.0_nm);
    const HeightMapFile heights = readHeightMapFile(output);
    const HeightMapFile certainty = readHeightMapFile(map);
    std::size_t certain = 0;
    for (std::size_t i = 0; i < expected.certain.size(); ++i) {
        if (!isFiniteHeight(expected.surface.heights[i])) {
            EXPECT_EQ(mapOf(certainty).invalid.at(i), 1);
            EXPECT_EQ(mapOf(heights).invalid.at(i), 1);
            continue;
        }
        EXPECT_EQ(mapOf(heights).heights[i],
                  expected.surface.datum + static_cast<double>(expected.surface.heights[i]));
        EXPECT_EQ(mapOf(certainty).heights[i], expected.certain[i]);
        certain += expected.certain[i];
    }
    EXPECT_NE(run.output.find("touched " + std::to_string(certain) + " of 7680 pixels"),
              std::string::npos)
        << run.output;
}

/// It was a map of heights of 0 and 1 m.
TEST_F(ConvertErosion, WritesACertaintyAsANumberWithoutAUnit) {
    ASSERT_EQ(convert(" --erode 15e-9 --certainty " + map.string()).exitCode, 0);
    const std::string gwy = scratch.file("certain.gwy").string();
    ASSERT_EQ(convert(" --force --erode 15e-9 --certainty " + gwy).exitCode, 0);
    for (const std::filesystem::path& file : {map, std::filesystem::path(gwy)}) {
        const ScanChannel& channel = readHeightMapFile(file).channels.at(0);
        EXPECT_EQ(channel.unit, "") << file;
        EXPECT_EQ(channel.lateralUnit, "m") << file;
        EXPECT_FALSE(channel.isHeight()) << file;
    }
    for (const char* const shape : {"certain.stl", "certain.vtp"}) {
        const auto run =
            convert(" --force --erode 15e-9 --certainty " + scratch.file(shape).string());
        EXPECT_EQ(run.exitCode, 2) << run.output;
        EXPECT_NE(run.output.find("a certainty has no unit"), std::string::npos) << run.output;
        EXPECT_NE(run.output.find(".gwy .gsf"), std::string::npos) << run.output;
        EXPECT_FALSE(std::filesystem::exists(scratch.file(shape)));
    }
}

TEST_F(ConvertErosion, ReplacesAFileOnlyWhenItIsAskedTo) {
    const auto earlier = scratch.write("certain.gsf", "earlier");
    const auto refused = convert(" --erode 15e-9 --certainty " + earlier.string());
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.output.find(earlier.string() + ": the file exists"), std::string::npos)
        << refused.output;
    EXPECT_EQ(test::contentOf(earlier), "earlier");
    EXPECT_FALSE(std::filesystem::exists(output));
    EXPECT_EQ(convert(" --force --erode 15e-9 --certainty " + earlier.string()).exitCode, 0);
    const std::string before = test::contentOf(output);
    const auto again = convert(" --level plane");
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.output.find("--force"), std::string::npos) << again.output;
    EXPECT_EQ(test::contentOf(output), before);
    EXPECT_EQ(convert(" --level plane --force").exitCode, 0);
    EXPECT_NE(test::contentOf(output), before);
}

TEST_F(ConvertErosion, RefusesWhatMakesNoSense) {
    for (const std::string options :
         {" --erode 0", " --erode -1e-9", " --erode nan", " --erode inf", " --erode tip",
          " --certainty map.gsf", " --erode 1e-9 --certainty ''"}) {
        const auto run = convert(options);
        EXPECT_EQ(run.exitCode, 2) << options << run.output;
    }
    EXPECT_EQ(convert(" --erode 1e-9 --certainty " + output.string()).exitCode, 1);
    EXPECT_EQ(convert(" --erode 1e-9 --certainty " + input.string()).exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(ConvertErosion, RefusesWhereItCannotWriteBeforeItErodesAndNamesTheFile) {
    const auto unknown = convert(" --erode 15e-9 --certainty map.foo");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.output.find("--certainty: map.foo"), std::string::npos) << unknown.output;
    const auto nowhere = convert(" --erode 15e-9 --certainty /nonexistent/map.gsf");
    EXPECT_EQ(nowhere.exitCode, 3);
    EXPECT_NE(nowhere.output.find("/nonexistent/map.gsf"), std::string::npos) << nowhere.output;
    for (const auto& run : {unknown, nowhere}) {
        EXPECT_EQ(run.output.find("eroded"), std::string::npos) << run.output;
    }
    EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(ConvertErosion, InfoSaysThatAScanHoldsTheShapeOfItsTip) {
    const auto text = test::runProgram("info " + input.string());
    EXPECT_NE(text.output.find("hold the shape of the tip"), std::string::npos) << text.output;
    const auto json = test::runProgram("info --json " + input.string());
    const nlohmann::json info = nlohmann::json::parse(json.output);
    EXPECT_NE(info["notes"].back().get<std::string>().find("hold the shape of the tip"),
              std::string::npos);
}

}  // namespace
}  // namespace asperity
