#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/io/curves/CurveFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

MeasuredForceCurve nanoscopeCurve(const NanoscopeCurveText& text, std::size_t index = 0) {
    const std::string bytes = nanoscopeCurveFile(text);
    return ForceCurveFile(MemoryBytes(bytes, "a.spm")).curve(index);
}

std::string refusalOfNanoscopeCurves(const NanoscopeCurveText& text) {
    return refusalOf([&] { (void)nanoscopeCurve(text); });
}

}  // namespace

TEST(NanoscopeCurves, StoreTheApproachBackwards) {
    const MeasuredForceCurve curve = nanoscopeCurve({});
    ASSERT_EQ(curve.segments.size(), 2U);
    const CurveSegment& approach = curve.segments[0];
    const auto isNear = [](double value) { return DoubleNear(value, 1e-15); };
    EXPECT_THAT(approach.signal,
                ElementsAre(isNear(0.0), isNear(0.0), isNear(0.005), isNear(0.01)));
    EXPECT_THAT(curve.segments[1].signal,
                ElementsAre(isNear(0.009), isNear(0.004), isNear(-0.002), isNear(0.0)));
    EXPECT_DOUBLE_EQ(approach.deflection[3], 0.01 * 30e-9) << "a missing unit is nm/V";
    EXPECT_DOUBLE_EQ(approach.force[3], 0.2 * approach.deflection[3]);
    EXPECT_DOUBLE_EQ(approach.base[1], 100e-9);
    EXPECT_DOUBLE_EQ(curve.segments[1].base[0], 400e-9);
    EXPECT_DOUBLE_EQ(approach.time[1], 1.0);
    EXPECT_DOUBLE_EQ(curve.segments[1].time[0], 4.0);
    EXPECT_DOUBLE_EQ(curve.segments[1].time[1], 4.5);
}

TEST(NanoscopeCurves, OfAVolumeFollowEachOtherWithEightBitsBehindThePoint) {
    NanoscopeCurveText text;
    text.version = "0x09200000";
    text.context = "FVOL";
    text.width = 4;
    text.perLine = 2;
    text.samples.clear();
    for (int curve = 0; curve < 4; ++curve) {
        for (const int sample : {10 + curve, 5, 0, 0, 9, 4, -2, 0}) {
            text.samples.push_back(256 * sample + (sample < 0 ? 255 : 0));
        }
    }
    const std::string bytes = nanoscopeCurveFile(text);
    const MemoryBytes source(bytes, "a.spm");
    const ForceCurveFile file(source);
    EXPECT_EQ(file.count(), 4U);
    EXPECT_EQ(file.grid().rows, 2);
    EXPECT_EQ(file.cell(3)->column, 1);
    EXPECT_NEAR(file.position(3)->x, 0.5e-6, 1e-15);
    EXPECT_DOUBLE_EQ(file.curve(3).segments[0].signal[3], 0.013);
    text.samples[0] = 3;  // no volume's count
    EXPECT_DOUBLE_EQ(nanoscopeCurve(text, 3).segments[0].signal[3], 0.013 * 256.0);
}

TEST(NanoscopeCurves, TruncatedKeepTheirWholeCurves) {
    NanoscopeCurveText text;
    text.dataLength = 32;
    const std::string bytes = nanoscopeCurveFile(text);
    const MemoryBytes source(bytes, "a.spm");
    const ForceCurveFile file(source);
    EXPECT_EQ(file.count(), 1U);
    EXPECT_THAT(file.notes(), Contains(HasSubstr("truncated: it holds 1 whole curves of 2")));
}

TEST(NanoscopeCurves, AreRefusedInWords) {
    NanoscopeCurveText text;
    text.counts = "some";
    EXPECT_THAT(refusalOfNanoscopeCurves(text),
                HasSubstr("a.spm: Ciao force image list: expected the "
                          "numbers of samples at 'Samps/line'"));
    text = {};
    text.dataLength = 15;
    EXPECT_THAT(refusalOfNanoscopeCurves(text), HasSubstr("'Data length' 15 is no multiple of 16"));
    text = {};
    text.zScale = "V [Sens. DeflSens] (V/LSB) 2.5 V";
    EXPECT_THAT(refusalOfNanoscopeCurves(text), HasSubstr("'@4:Z scale'"));
    text = {};
    text.rampSize = "V [Sens. Unknown] (0.006 V/LSB) 40.0 V";
    EXPECT_THAT(refusalOfNanoscopeCurves(text), HasSubstr("length of the ramp"));
    text = {};
    text.samples.resize(4);
    text.dataLength = 16;
    EXPECT_THAT(refusalOfNanoscopeCurves(text), HasSubstr("end before the first curve"));
}

}  // namespace asperity::test
