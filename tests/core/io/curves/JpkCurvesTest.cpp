#include "core/io/curves/ForceCurveFile.h"
#include "core/io/curves/jpk/JpkProperties.h"
#include "tests/core/io/curves/CurveFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

CurveContents jpkContents(const JpkCurveText& text, std::size_t index = 0,
                          const CurveReadOptions& options = {}) {
    const std::string bytes = jpkCurveFile(text);
    return ForceCurveFile(MemoryBytes(bytes, "a.jpk-force"), options).contents(index);
}

std::string refusalOfJpkCurves(const JpkCurveText& text, std::size_t index = 0,
                               const CurveReadOptions& options = {}) {
    return refusalOf([&] { (void)jpkContents(text, index, options); });
}

}  // namespace

TEST(JpkCurves, HaveHeightDeflectionAndForceOfTheirSlots) {
    const CurveContents contents = jpkContents({{{"", jpkCycle()}}, {}});
    ASSERT_THAT(contents.curve.segments, SizeIs(2));
    const CurveSegment& approach = contents.curve.segments[0];
    EXPECT_EQ(approach.kind, CurveSegmentKind::Approach);
    EXPECT_DOUBLE_EQ(approach.base[3], -(100e-9 + 1e-6)) << "a height grows away from the sample";
    EXPECT_DOUBLE_EQ(approach.signal[3], 0.1);
    EXPECT_DOUBLE_EQ(approach.deflection[3], 5e-9);
    EXPECT_DOUBLE_EQ(approach.force[3], 5e-10);
    EXPECT_DOUBLE_EQ(contents.curve.invols, 5e-8);
    EXPECT_DOUBLE_EQ(contents.curve.stiffness, 0.1);
    EXPECT_THAT(approach.time, ElementsAre(0.0, 0.5, 1.0, 1.5));
    EXPECT_DOUBLE_EQ(contents.curve.segments[1].time[0], 2.0);
    EXPECT_EQ(contents.heightChannel, "height");
}

TEST(JpkCurves, OfAMapAreSortedByNumber) {
    JpkCurveText map;
    for (const char* const folder : {"index/10/", "index/9/", "index/2/"}) {
        map.curves[folder] = jpkCycle();
    }
    map.curves["index/10/"][0].deflection = {0, 0, 0, 7};
    const std::string bytes = jpkCurveFile(map);
    const MemoryBytes source(bytes, "a.jpk-force-map");
    const ForceCurveFile file(source);
    ASSERT_EQ(file.count(), 3U);
    EXPECT_DOUBLE_EQ(file.curve(2).segments[0].signal[3], 0.07);
    EXPECT_EQ(file.grid().columns, 2);
    EXPECT_EQ(file.cell(1)->row, 4);
    EXPECT_EQ(file.cell(1)->column, 1 - 0);  // number 9 of rows of two: row 4, forth
    EXPECT_FALSE(file.hasImage());
    EXPECT_THAT(refusalOf([&] { (void)file.curve(3); }),
                HasSubstr("there is no curve 3: the file holds 3, of the indexes 0 to 2"));
}

TEST(JpkCurves, LeaveOutEmptyAndOnePointSegments) {
    JpkCurveText text{{{"", jpkCycle()}}, {}};
    JpkSegmentText pause;
    pause.style = "pause";
    pause.height = {100};
    pause.deflection = {10};
    pause.points = "1";
    pause.duration = "3.0";
    text.curves[""].insert(text.curves[""].begin() + 1, pause);
    const CurveContents contents = jpkContents(text);
    ASSERT_THAT(contents.curve.segments, SizeIs(2));
    EXPECT_THAT(contents.notes, Contains(HasSubstr("segment 1 (pause) has one point")));
    EXPECT_DOUBLE_EQ(contents.curve.segments[1].time[0], 5.0) << "its time has passed";
}

TEST(JpkCurves, TakeTheFewerPointsOfHeaderAndChannels) {
    JpkCurveText text{{{"", jpkCycle()}}, {}};
    text.curves[""][0].points = "3";
    text.curves[""][1].height.resize(2);
    const CurveContents contents = jpkContents(text);
    EXPECT_THAT(contents.curve.segments[0].force, SizeIs(3));
    EXPECT_THAT(contents.curve.segments[1].force, SizeIs(2));
    EXPECT_THAT(contents.curve.segments[1].base, SizeIs(2));
    EXPECT_THAT(contents.notes, Contains(HasSubstr("segments/1/: header and channels differ")));
}

TEST(JpkCurves, AreRefusedWithTheChannelThatDoesNotFit) {
    const JpkCurveText whole{{{"", jpkCycle()}}, {}};
    const std::string slots = "lcd-info.1.conversion-set.conversion.";
    JpkCurveText text = whole;
    text.curves[""][1].hasDeflectionFile = false;
    EXPECT_THAT(refusalOfJpkCurves(text),
                HasSubstr("channel vDeflection: the archive has no member "
                          "'segments/1/channels/vDeflection.dat'"));
    text = whole;
    text.shared[slots + "distance.base-calibration-slot"] = "force";
    EXPECT_THAT(refusalOfJpkCurves(text),
                HasSubstr("channel vDeflection: its conversions form a circle"));
    text = whole;
    text.shared[slots + "distance.scaling.multiplier"] = "";
    EXPECT_THAT(refusalOfJpkCurves(text),
                HasSubstr("channel vDeflection: expected a linear scaling"));
    text = whole;
    text.shared["lcd-info.0.encoder.type"] = "signedtriple";
    EXPECT_THAT(refusalOfJpkCurves(text),
                HasSubstr("channel height: no type of samples is called 'signedtriple'"));
    text = whole;
    text.shared["lcd-info.0.encoder.type"] = "signedinteger";
    text.curves[""][0].height.resize(3);
    EXPECT_THAT(refusalOfJpkCurves(text), HasSubstr("6 bytes are no whole samples of 4"));
    CurveReadOptions options;
    options.height = "mirror";
    EXPECT_THAT(refusalOfJpkCurves(whole, 0, options),
                HasSubstr("there is no height channel 'mirror': it has 'height'"));
}

TEST(JpkCurves, LoseWhatTheirSlotsDoNotDefine) {
    const std::string slots = "lcd-info.1.conversion-set.conversion.";
    JpkCurveText text{{{"", jpkCycle()}}, {}};
    text.shared[slots + "force.defined"] = "false";
    EXPECT_TRUE(jpkContents(text).curve.segments[0].force.empty());
    EXPECT_EQ(jpkContents(text).curve.stiffness, 0.0);
    text.shared[slots + "distance.defined"] = "false";
    EXPECT_TRUE(jpkContents(text).curve.segments[0].deflection.empty());
    EXPECT_THAT(jpkContents(text).curve.segments[0].signal, SizeIs(4));
}

TEST(JpkCurves, CutOffAreRefused) {
    const std::string bytes = jpkCurveFile({{{"", jpkCycle()}}, {}});
    EXPECT_FALSE(refusalOf([&] {
                     const MemoryBytes cut(std::string_view(bytes).substr(0, bytes.size() / 2),
                                           "a");
                     (void)ForceCurveFile(cut);
                 }).empty());
}

TEST(JpkProperties, ReadEscapesAndReferences) {
    const JpkProperties shared("lcd-info.3.a.b=7\nlcd-info.3.more.*=4\nmore.4.c=9\n");
    const JpkProperties own("# comment=1\nkey\\:one = 100\\u00B5m \nx.lcd-info.*=3\nx.a.d=own=1\n",
                            &shared);
    EXPECT_EQ(own.text("key:one"), "100\xC2\xB5m");
    EXPECT_EQ(own.text("x.a.b"), "7");
    EXPECT_EQ(own.text("x.a.d"), "own=1");
    EXPECT_EQ(own.text("x.c"), "9") << "a reference in what was inserted";
    EXPECT_FALSE(own.find("comment"));
    const JpkProperties circle("a.a.*=1\na.1.a.*=1\n");
    EXPECT_FALSE(circle.find("a.b"));
}

}  // namespace asperity::test
