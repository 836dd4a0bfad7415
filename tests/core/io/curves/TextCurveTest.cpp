#include "core/Error.h"
#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/io/heightmap/ZipFiles.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

CurveReadOptions namedColumns(const std::string& columns, int skipped = 0) {
    CurveReadOptions options;
    options.columns = givenColumns(columns);
    options.skippedLines = skipped;
    return options;
}

MeasuredForceCurve textCurve(const std::string& text, const CurveReadOptions& options = {}) {
    return ForceCurveFile(MemoryBytes(text, "a.txt"), options).curve(0);
}

std::string refusalOfColumns(const std::string& columns) {
    try {
        (void)givenColumns(columns);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST(TextCurve, TakesColumnsThatTheUserNames) {
    for (const char* const text :
         {"weg kraft zeit\n0.1 2,5 0\n0.2 7,5 3\n0.15 1 5\n",
          "0,1\t2.5\t0\n0,2\t7.5\t3\n,15\t1\t5\n", "0.1;2.5;0\n0.2;7.5;3\n0.15;1;5\n",
          "0.1,2.5,0\n0.2,7.5,3\n0.15,1,5\n"}) {
        const MeasuredForceCurve curve =
            textCurve(text, namedColumns("base=1:um,deflection=2:nm,time=3:ms"));
        ASSERT_THAT(curve.segments, SizeIs(1)) << "one point of the retract is left out: " << text;
        EXPECT_DOUBLE_EQ(curve.segments[0].base[1], 0.2e-6) << text;
        EXPECT_DOUBLE_EQ(curve.segments[0].deflection[1], 7.5e-9) << text;
        EXPECT_DOUBLE_EQ(curve.segments[0].time[1], 3e-3) << text;
    }
}

TEST(TextCurve, SkipsLinesAndReadsLatinOne) {
    const MeasuredForceCurve curve = textCurve("1 2 3\n\xB5m\n5 0\n4 1\n3 2\n",
                                               namedColumns("separation=1:\xB5m,signal=2:mV", 2));
    ASSERT_THAT(curve.segments[0].separation, SizeIs(3));
    EXPECT_DOUBLE_EQ(curve.segments[0].separation[0], 5e-6);
    EXPECT_DOUBLE_EQ(curve.segments[0].signal[2], 2e-3);
}

TEST(TextCurve, TakesColumnsOfTheRetractAlone) {
    const MeasuredForceCurve curve = textCurve(
        "1 0 0\n2 0 -3\n3 7 7\n", namedColumns("base=1:nm,force=2:nN,retract-force=3:nN"));
    ASSERT_THAT(curve.segments, SizeIs(2));
    EXPECT_DOUBLE_EQ(curve.segments[1].base[0], 3e-9) << "the retract begins at the contact";
    EXPECT_DOUBLE_EQ(curve.segments[1].force[1], -3e-9);
}

TEST(TextCurve, RefusesColumnsInWords) {
    EXPECT_THAT(refusalOfColumns("base"), HasSubstr("expected QUANTITY=NUMBER:UNIT"));
    EXPECT_THAT(refusalOfColumns("way=1"), HasSubstr("expected base, separation"));
    EXPECT_THAT(refusalOfColumns("base=0:um"), HasSubstr("the first is 1"));
    EXPECT_THAT(refusalOfColumns("base=1:nN"), HasSubstr("expected a unit of m"));
    EXPECT_THAT(refusalOfColumns("force=1"), HasSubstr("no distance"));
    EXPECT_THAT(refusalOfColumns("base=1,time=2"), HasSubstr("nothing of the lever"));
    EXPECT_THAT(
        refusalOf([] { (void)textCurve("1 2\n2 3\nend\n", namedColumns("base=1,force=2")); }),
        HasSubstr("a.txt: line 3: expected numbers in the named columns, found 'end'"));
    EXPECT_THAT(refusalOf([] { (void)textCurve("1 2\n2 3\n", namedColumns("base=1,force=3")); }),
                HasSubstr("no point"));
    CurveReadOptions options;
    options.height = "z";
    EXPECT_THAT(refusalOf([&] { (void)textCurve("z [nm],force [nN]\n1,2\n2,3\n", options); }),
                HasSubstr("no height channels to choose from"));
}

TEST(TextCurve, KeepsTimesAndSignals) {
    const MeasuredForceCurve curve =
        textCurve("segment,time_s,base_m,signal_V\n0:approach,0,1,0\n"
                  "0:approach,1,2,5\n1:retract,2,2,4\n1:retract,3,1,-1\n");
    ASSERT_THAT(curve.segments, SizeIs(2));
    EXPECT_THAT(curve.segments[1].time, ElementsAre(2, 3));
    EXPECT_THAT(curve.segments[1].signal, ElementsAre(4, -1));
    EXPECT_TRUE(curve.segments[1].force.empty());
}

TEST(TextCurve, OfNtMdtRunsFromTheFarEnd) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ForceCurveFile file(
        sharedData("curves/original/"
                   "fmt-ntmdt-txt-fd_2015_01_17_gel4-0_1_mQ_adh_6B_Curve_DFL_Height_51.txt"));
    EXPECT_EQ(file.format(), "NT-MDT text");
    const CurveContents contents = file.contents(0);
    ASSERT_THAT(contents.curve.segments, SizeIs(2));
    const CurveSegment& approach = contents.curve.segments[0];
    EXPECT_THAT(approach.signal, SizeIs(1000));
    EXPECT_DOUBLE_EQ(approach.signal.back(), 1.4726);
    EXPECT_DOUBLE_EQ(approach.base.back(), 7999.9482e-9);
    EXPECT_DOUBLE_EQ(contents.curve.segments[1].signal.front(), 1.4711);
    EXPECT_THAT(contents.notes, Contains(HasSubstr("names no units")));
}

TEST(TextCurve, OfNtMdtIsNoGridOfPoints) {
    std::string points;
    std::string curve;
    for (int i = 0; i < 30; ++i) {
        points += std::to_string(i % 15) + "\t" + std::to_string(i / 15) + "\t1.5\n";
        curve += std::to_string(i) + "\t" + std::to_string(i / 15) + "\t1.5\n";
    }
    EXPECT_FALSE(holdsForceCurves(MemoryBytes(points, "a.txt")));
    EXPECT_TRUE(holdsForceCurves(MemoryBytes(curve, "a.txt")));
}

TEST(TextCurve, OfAfmWorkshopInVoltsIsASignal) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ForceCurveFile file(
        sharedData("curves/original/fmt-afm-workshop-fd_single_2021-01-15.csv"));
    EXPECT_EQ(file.format(), "AFM Workshop .csv");
    const MeasuredForceCurve curve = file.curve(0);
    EXPECT_DOUBLE_EQ(curve.segments[0].signal.front(), 0.8262);
    EXPECT_TRUE(curve.segments[0].force.empty());
}

TEST(TextCurve, InAZipIsOneOfEachText) {
    const std::string text = "z [nm],force [nN]\n1,2\n2,3\n";
    const std::string bytes = zipFile({{"a.txt", text}, {"picture.png", "x"}, {"b/c.TXT", text}});
    const MemoryBytes source(bytes, "a.zip");
    const ForceCurveFile file(source);
    EXPECT_EQ(file.count(), 2U);
    EXPECT_THAT(file.contents(1).notes, Contains("member b/c.TXT"));
    const std::string other = zipFile({{"a.txt", "no table"}});
    const MemoryBytes letters(other, "b.zip");
    EXPECT_THAT(refusalOf([&] { (void)ForceCurveFile(letters).curve(0); }),
                HasSubstr("no line names a distance"));
}

}  // namespace asperity::test
