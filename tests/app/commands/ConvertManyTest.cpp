#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "tests/app/ProgramRun.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// `asperity convert`: many files, all channels, 16-bit TIFF.

namespace asperity {

namespace {

using testing::HasSubstr;
using testing::Not;

/// To the bit, or no numbers both.
bool areSame(const std::vector<double>& ours, const std::vector<double>& theirs) {
    return std::ranges::equal(ours, theirs, [](double one, double other) {
        return one == other || (std::isnan(one) && std::isnan(other));
    });
}

class ConvertMany : public testing::Test {
protected:
    void SetUp() override {
        writeHeightMap(scratch.file("a.gwy"), test::bumpyMap(8, 6), {.title = "Height"});
        writeHeightMap(scratch.file("b.gsf"), test::bumpyMapWithHoles(8, 6), {.title = "Height"});
    }
    [[nodiscard]] test::ProgramRun convert(const std::string& arguments) const {
        return test::runProgram("convert " + arguments);
    }
    [[nodiscard]] std::string path(const std::string& name) const {
        return scratch.file(name).string();
    }
    [[nodiscard]] std::string into(const std::string& format) const {
        return " --out-dir " + path("out") + " --to " + format;
    }
    [[nodiscard]] bool isThere(const std::string& name) const {
        return std::filesystem::exists(scratch.file("out") / name);
    }

    test::ScratchFolder scratch;
};

TEST_F(ConvertMany, WritesAFileForEachIntoTheFolder) {
    const auto run = convert(path("a.gwy") + " " + path("b.gsf") + into("exr"));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr(path("a.gwy") + " -> "));
    EXPECT_THAT(run.output, HasSubstr("'Height', 8 x 6 pixels, 2 of them without data"));
    EXPECT_EQ(run.lines(), 2) << run.output;
    const ScanChannel read = readHeightMapFile(scratch.file("out") / "b.exr", {}).channels.at(0);
    EXPECT_EQ(read.map.invalid, test::bumpyMapWithHoles(8, 6).invalid);
}

TEST_F(ConvertMany, GoesOnAfterABadOneAndEndsWith1) {
    const std::string bad = scratch.write("bad.gsf", "no scan").string();
    const auto run =
        convert(path("a.gwy") + " " + bad + " " + path("none") + " " + path("b.gsf") + into("png"));
    EXPECT_EQ(run.exitCode, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("asperity: " + bad + ": "));
    EXPECT_THAT(run.output, HasSubstr("2 of 4 files could not be converted"));
    EXPECT_EQ(run.lines(), 6) << run.output << "each file, a note on pits, the sum";
    EXPECT_TRUE(isThere("a.png") && isThere("b.png"));
    EXPECT_FALSE(isThere("bad.png"));
}

TEST_F(ConvertMany, InputsOfOneNameDoNotReplaceEachOther) {
    std::filesystem::create_directory(scratch.file("more"));
    for (const char* name : {"scan.001", "scan.002", "more/scan.001"}) {
        std::filesystem::copy_file(scratch.file("a.gwy"), scratch.file(name));
    }
    const auto run = convert(path("scan.001") + " " + path("scan.002") + " " +
                             path("more/scan.001") + into("gsf"));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(isThere("scan.001.gsf") && isThere("scan.002.gsf")) << run.output;
    EXPECT_FALSE(isThere("scan.gsf"));
    EXPECT_TRUE(isThere("scan.001-2.gsf"));
}

/// A scan is often the only copy of a measurement.
TEST_F(ConvertMany, NoOutputReplacesAnotherInput) {
    std::filesystem::create_directory(scratch.file("out"));
    std::filesystem::copy_file(scratch.file("b.gsf"), scratch.file("out") / "a.gsf");
    const std::string before = test::contentOf(scratch.file("out") / "a.gsf");
    const auto run = convert(path("a.gwy") + " " + path("out/a.gsf") + into("gsf") + " --force");
    EXPECT_EQ(run.exitCode, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("is the file itself"));
    EXPECT_EQ(test::contentOf(scratch.file("out") / "a.gsf"), before);
}

TEST_F(ConvertMany, NoOutputReplacesAnotherInputUnderAnotherName) {
    std::filesystem::create_directory(scratch.file("out"));
    std::filesystem::copy_file(scratch.file("b.gsf"), scratch.file("d.gsf"));
    std::filesystem::create_hard_link(scratch.file("d.gsf"), scratch.file("out") / "b.gsf");
    const std::string before = test::contentOf(scratch.file("d.gsf"));
    const auto run = convert(path("b.gsf") + " " + path("d.gsf") + into("gsf") + " --force");
    EXPECT_EQ(run.exitCode, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("is another input"));
    EXPECT_EQ(test::contentOf(scratch.file("d.gsf")), before);
}

TEST_F(ConvertMany, ReplacesFilesOnlyWithForce) {
    EXPECT_EQ(convert(path("a.gwy") + into("gsf")).exitCode, 0);
    const auto again = convert(path("a.gwy") + " " + path("b.gsf") + into("gsf"));
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.output, HasSubstr("a.gsf: the file exists"));
    EXPECT_TRUE(isThere("b.gsf"));
    EXPECT_EQ(convert(path("a.gwy") + into("gsf") + " --force").exitCode, 0);
}

TEST_F(ConvertMany, SaysWhereSinglePrecisionLosesTheRelief) {
    HeightMap map = test::bumpyMap(8, 6);
    for (double& height : map.heights) {
        height = 5e-3 + 1e-3 * height;
    }
    writeHeightMap(scratch.file("high.txt"), map, {});
    const std::string lost = "is written in steps of about";
    EXPECT_THAT(convert(path("high.txt") + into("gsf")).output, HasSubstr(lost));
    EXPECT_THAT(convert(path("high.txt") + into("tiff")).output, HasSubstr(lost));
    EXPECT_THAT(convert(path("high.txt") + into("gwy")).output, Not(HasSubstr(lost)));
    EXPECT_THAT(convert(path("b.gsf") + into("gsf")).output, Not(HasSubstr(lost)));
}

TEST_F(ConvertMany, SaysWhatOtherProgramsMakeOfPixelsWithoutData) {
    const auto counts = convert(path("b.gsf") + into("png"));
    EXPECT_THAT(counts.output, HasSubstr("other programs show pits"));
    EXPECT_THAT(convert(path("b.gsf") + into("exr")).output, Not(HasSubstr("pits")));
}

TEST_F(ConvertMany, OptionsHoldForEach) {
    const auto run = convert(path("a.gwy") + " " + path("b.gsf") + into("gwy") +
                             " --channel Height --level plane --residual");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    writeHeightMap(scratch.file("bare.tiff"), rowsOf(test::bumpyMap(4, 4)), {.unit = ""});
    const auto scaled =
        convert(path("bare.tiff") + into("gsf") + " --size 4um --z-unit nm --z-scale 2");
    EXPECT_EQ(scaled.exitCode, 0) << scaled.output;
    const ScanChannel read = readHeightMapFile(scratch.file("out") / "bare.gsf", {}).channels.at(0);
    EXPECT_DOUBLE_EQ(read.map.sizeX(), 4e-6);
    EXPECT_EQ(read.unit, "m");
}

TEST_F(ConvertMany, RefusesWrongCalls) {
    for (const std::string& call :
         {path("a.gwy") + " --out-dir " + path("out"), path("a.gwy") + " --to gsf",
          path("a.gwy") + into("doc"), path("a.gwy"),
          path("a.gwy") + " " + path("b.gsf") + " " + path("c.gsf"),
          path("a.gwy") + into("gsf") + " --all",
          path("a.gwy") + into("gsf") + " --erode 1e-9 --certainty " + path("c.gsf")}) {
        const auto run = convert(call);
        EXPECT_EQ(run.exitCode, 2) << call << "\n" << run.output;
    }
    EXPECT_FALSE(std::filesystem::exists(scratch.file("out")));
    EXPECT_EQ(convert(path("a.gwy") + " --out-dir " + path("b.gsf") + " --to gsf").exitCode, 3);
}

TEST_F(ConvertMany, SixteenBitsAreForTiff) {
    EXPECT_EQ(convert(path("b.gsf") + " " + path("c.tif") + " --bits 16").exitCode, 0);
    const ScanChannel read = readHeightMapFile(scratch.file("c.tif"), {}).channels.at(0);
    EXPECT_EQ(read.map.invalid, test::bumpyMapWithHoles(8, 6).invalid);
    EXPECT_EQ(read.unit, "m");
    EXPECT_LT(std::filesystem::file_size(scratch.file("c.tif")), 1500U);
    const auto refused = convert(path("b.gsf") + " " + path("d.gsf") + " --bits 16");
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.output, HasSubstr(".tiff"));
    EXPECT_EQ(convert(path("b.gsf") + " " + path("d.tif") + " --bits 12").exitCode, 2);
}

TEST_F(ConvertMany, AllChannelsOfAFileGoIntoOne) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const std::string& scan : test::realScans()) {
        SCOPED_TRACE(scan);
        const std::filesystem::path input = test::sharedData("afm/" + scan);
        const auto run = convert(input.string() + " " + path("all.gwy") + " --all --force");
        ASSERT_EQ(run.exitCode, 0) << run.output;
        const HeightMapFile before = readHeightMapFile(input, {});
        const HeightMapFile after = readHeightMapFile(scratch.file("all.gwy"), {});
        ASSERT_EQ(after.channels.size(), before.channels.size());
        for (std::size_t i = 0; i < after.channels.size(); ++i) {
            SCOPED_TRACE(before.channels[i].name);
            EXPECT_TRUE(after.channels[i].name.starts_with(before.channels[i].name));
            EXPECT_EQ(after.channels[i].direction, before.channels[i].direction);
            EXPECT_EQ(after.channels[i].metadata, before.channels[i].metadata);
            const PhysicalUnit unit = parseUnit(before.channels[i].unit);
            EXPECT_EQ(after.channels[i].unit, unit.base);
            std::vector<double> values = before.channels[i].map.heights;
            std::ranges::for_each(values, [&unit](double& value) { value *= unit.factor; });
            EXPECT_TRUE(areSame(after.channels[i].map.heights, values));
            EXPECT_EQ(after.channels[i].map.invalid, before.channels[i].map.invalid);
            EXPECT_DOUBLE_EQ(after.channels[i].map.sizeX(), before.channels[i].map.sizeX());
        }
    }
}

TEST_F(ConvertMany, AllChannelsGoIntoNothingElseAndAsTheyAre) {
    const auto gsf = convert(path("a.gwy") + " " + path("c.gsf") + " --all");
    EXPECT_EQ(gsf.exitCode, 2);
    EXPECT_THAT(gsf.output, HasSubstr("several go into .gwy"));
    for (const char* option : {" --level plane", " --channel Height", " --erode 1e-9"}) {
        EXPECT_EQ(convert(path("a.gwy") + " " + path("c.gwy") + " --all" + option).exitCode, 2);
    }
    EXPECT_FALSE(std::filesystem::exists(scratch.file("c.gwy")));
}

}  // namespace
}  // namespace asperity
