#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace asperity::test {

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr double kIgorPadding = std::numeric_limits<double>::quiet_NaN();

/// Six samples of Raw, Defl and ZSnsr: four of the approach, two of the retract.
IgorWaveText asylumCurve() {
    IgorWaveText wave;
    wave.counts = {6, 3, 0, 0};
    wave.steps = {0.5, 1.0, 1.0, 1.0};
    wave.columnLabels = {"", "Raw", "Defl", "ZSnsr"};
    wave.note = "SpringConstant: 0.5\rInvOLS: 4e-08\rXLVDT:1e-06\rYLVDT:-2e-06\r"
                "Indexes: 0,3,5\rDirection: NaN,1,-1,\r";
    wave.footer = "0292 Force";
    wave.numbers = {10, 11, 12, 13, 12, 11, 0, 0, 1, 2, 1, -1, 20, 21, 22, 23, 22, 21};
    return wave;
}

CurveContents igorContents(const IgorWaveText& wave, const CurveReadOptions& options = {}) {
    const std::string bytes = igorFile(wave);
    return ForceCurveFile(MemoryBytes(bytes, "a.ibw"), options).contents(0);
}

/// One channel of a curve in a file of its own.
IgorWaveText channelWave(const std::vector<double>& numbers) {
    IgorWaveText wave = asylumCurve();
    wave.counts = {static_cast<std::int32_t>(numbers.size()), 0, 0, 0};
    wave.columnLabels.clear();
    wave.footer.clear();
    wave.numbers = numbers;
    return wave;
}

/// The same in version 2.
std::string oldWave(const std::vector<double>& numbers, const std::string& note) {
    const std::string data = samples(SampleType::Float32, ByteOrder::Little, numbers);
    std::string bytes(126, '\0');
    const auto put = [&bytes](std::size_t offset, auto value) {
        std::string raw;
        appendLittleEndian(raw, value);
        bytes.replace(offset, raw.size(), raw);
    };
    put(0, std::int16_t{2});
    put(2, static_cast<std::int32_t>(110 + data.size() + 16));
    put(6, static_cast<std::int32_t>(note.size()));
    put(16, std::int16_t{2});
    put(58, static_cast<std::int32_t>(numbers.size()));
    put(64, 0.5);
    unsigned sum = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        sum += littleEndian<std::uint16_t>(bytes.data() + i);
    }
    put(14, static_cast<std::uint16_t>(-sum));
    return bytes + data + std::string(16, '\0') + note;
}

}  // namespace

TEST(IgorCurves, AreSplitByTheNote) {
    const CurveContents contents = igorContents(asylumCurve());
    ASSERT_THAT(contents.curve.segments, SizeIs(2));
    const CurveSegment& approach = contents.curve.segments[0];
    EXPECT_THAT(approach.base, ElementsAre(20, 21, 22, 23)) << "the sensor, towards the sample";
    EXPECT_THAT(approach.deflection, ElementsAre(0, 0, 1, 2));
    EXPECT_DOUBLE_EQ(approach.force[3], 1.0);
    EXPECT_EQ(contents.curve.segments[1].kind, CurveSegmentKind::Retract);
    EXPECT_THAT(contents.curve.segments[1].time, ElementsAre(2.0, 2.5));
    EXPECT_DOUBLE_EQ(contents.curve.invols, 4e-8);
    EXPECT_EQ(contents.heightChannel, "ZSnsr");
    CurveReadOptions options;
    options.height = "Raw";
    EXPECT_DOUBLE_EQ(igorContents(asylumCurve(), options).curve.segments[0].base[0], 10.0);
}

TEST(IgorCurves, LosePaddingAndHaveNoForceWithoutASpringConstant) {
    IgorWaveText wave = asylumCurve();
    wave.numbers[11] = kIgorPadding;
    wave.note = "XLVDT:1e-06\rIndexes: 0,3,5\rDirection: NaN,1,-1,\r";
    const CurveContents contents = igorContents(wave);
    ASSERT_THAT(contents.curve.segments, SizeIs(1)) << "one sample is left of the retract";
    EXPECT_THAT(contents.notes, Contains(HasSubstr("segment 1 (retract) has one point")));
    EXPECT_TRUE(contents.curve.segments[0].force.empty());
}

TEST(IgorCurves, WithoutIndexesTurnAtTheirLargestDeflection) {
    for (const char* const indexes :
         {"", "Indexes: 0,9,5\rDirection: NaN,1,-1,\r", "Indexes: 0,x,5\rDirection: NaN,1,-1,\r"}) {
        IgorWaveText wave = asylumCurve();
        wave.note = indexes;
        const CurveContents contents = igorContents(wave);
        ASSERT_THAT(contents.curve.segments, SizeIs(2)) << indexes;
        EXPECT_THAT(contents.curve.segments[0].base, SizeIs(4));
    }
}

TEST(IgorCurves, OfAWaveForEachChannelLieSideBySide) {
    for (const bool isOld : {false, true}) {
        const ScratchFolder folder;
        const auto write = [&](const char* name, const std::vector<double>& numbers) {
            const IgorWaveText wave = channelWave(numbers);
            return folder.write(name, isOld ? oldWave(numbers, wave.note) : igorFile(wave));
        };
        const auto deflection = write("Line0001Point0002Defl.ibw", {0, 0, 1, 2, 1, -1});
        EXPECT_THAT(refusalOf([&] { (void)readForceCurve(deflection); }),
                    HasSubstr("'Line0001Point0002ZSnsr.ibw' or Raw, must lie beside it"));
        write("Line0001Point0002Raw.ibw", {10, 11, 12, 13, 12, 11});
        const auto sensor = write("Line0001Point0002ZSnsr.ibw", {20, 21, 22, 23, 22, 21});
        for (const auto& file : {deflection, sensor}) {
            const CurveContents contents = ForceCurveFile(file).contents(0);
            ASSERT_THAT(contents.curve.segments, SizeIs(2));
            EXPECT_THAT(contents.curve.segments[0].base, ElementsAre(20, 21, 22, 23));
            EXPECT_DOUBLE_EQ(contents.curve.segments[0].force[3], 1.0);
            EXPECT_DOUBLE_EQ(contents.curve.segments[1].time[0], 2.0);
        }
    }
}

TEST(IgorCurves, AreRefusedWithoutTheirChannels) {
    IgorWaveText wave = asylumCurve();
    wave.columnLabels = {"", "Raw", "Amp", "ZSnsr"};
    EXPECT_THAT(refusalOf([&] { (void)igorContents(wave); }), HasSubstr("no channel Defl"));
    const std::string bytes = igorFile(asylumCurve());
    EXPECT_THAT(refusalOf([&] {
                    const MemoryBytes cut(std::string_view(bytes).substr(0, 400), "a.ibw");
                    (void)ForceCurveFile(cut);
                }),
                HasSubstr("a.ibw"));
}

}  // namespace asperity::test
