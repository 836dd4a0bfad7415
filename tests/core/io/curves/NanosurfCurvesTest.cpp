#include "core/io/curves/ForceCurveFile.h"
#include "core/io/curves/ThermalSpectrumFile.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// Two curves of three points.
NanosurfChannel specChannel(const std::string& frame, const std::string& name,
                            const std::string& unit, const std::vector<double>& numbers) {
    NanosurfChannel channel;
    channel.frame = frame;
    channel.name = name;
    channel.unit = unit;
    channel.numbers = numbers;
    return channel;
}

double valueOf(double count) { return -1e-6 + 2e-6 * (count + 32768.0) / 65536.0; }

}  // namespace

TEST(NanosurfCurves, HaveASegmentForEachFrame) {
    const std::string bytes =
        nanosurfFile({specChannel("Spec forward", "Deflection", "N", {0, 0, 9, 0, 1, 8}),
                      specChannel("Spec forward", "Z-Axis", "m", {30, 20, 10, 31, 21, 11}),
                      specChannel("Spec forward", "Z-Axis Sensor", "m", {33, 22, 11, 34, 23, 12}),
                      specChannel("Spec backward", "Deflection", "N", {9, -3, 0, 8, -4, 0}),
                      specChannel("Spec backward", "Z-Axis Sensor", "m", {11, 22, 33, 12, 23, 34}),
                      NanosurfChannel{}});
    const MemoryBytes source(bytes, "a.nid");
    const ForceCurveFile file(source);
    EXPECT_EQ(file.count(), 2U);
    EXPECT_TRUE(file.hasImage());
    const CurveContents contents = file.contents(1);
    ASSERT_THAT(contents.curve.segments, SizeIs(2));
    const CurveSegment& approach = contents.curve.segments[0];
    EXPECT_DOUBLE_EQ(approach.force[2], valueOf(8));
    EXPECT_DOUBLE_EQ(approach.base[2], -valueOf(12)) << "the sensor, growing towards the sample";
    EXPECT_EQ(contents.heightChannel, "Z-Axis Sensor");
    EXPECT_EQ(contents.curve.segments[1].kind, CurveSegmentKind::Retract);
}

TEST(NanosurfCurves, TruncatedAreRefused) {
    std::string bytes =
        nanosurfFile({specChannel("Spec forward", "Deflection", "V", {0, 0, 9, 0, 1, 8})});
    bytes.pop_back();
    const MemoryBytes source(bytes, "a.nid");
    EXPECT_THAT(refusalOf([&] { (void)ForceCurveFile(source); }), HasSubstr("it is truncated"));
}

TEST(ThermalSpectrum, IsTheSquareOfTheStoredDensity) {
    NanosurfChannel spectrum =
        specChannel("Spectrum FFT", "Amplitude Spectral Density", "m/sqrt(Hz)", {1, 2, 3});
    spectrum.lines = "1";
    const std::string bytes = nanosurfFile({spectrum});
    const MemoryBytes source(bytes, "a.nid");
    EXPECT_TRUE(holdsThermalSpectrum(source));
    const ThermalSpectrum read = readThermalSpectrum(source);
    EXPECT_DOUBLE_EQ(read.power[2], valueOf(3) * valueOf(3));
    EXPECT_EQ(read.resonance, 0.0);
    EXPECT_THAT(refusalOf([&] { (void)ForceCurveFile(source); }), HasSubstr("thermal spectrum"));
    const std::string image = nanosurfFile({NanosurfChannel{}});
    EXPECT_THAT(refusalOf([&] { (void)readThermalSpectrum(MemoryBytes(image, "b.nid")); }),
                HasSubstr("b.nid: [DataSet]: it lists no thermal spectrum"));
}

}  // namespace asperity::test
