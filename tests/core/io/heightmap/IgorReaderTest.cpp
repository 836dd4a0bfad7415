#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

HeightMapFile readAsIgor(const std::string& bytes) { return readHeightMapBytes(bytes, "wave.ibw"); }

ScanChannel igorChannel(const IgorWaveText& wave) {
    return readAsIgor(igorFile(wave)).channels.at(0);
}

std::string refusalOfIgor(const std::string& bytes) {
    return refusalOf([&] { (void)readAsIgor(bytes); });
}

IgorWaveText asylumWave() {
    IgorWaveText wave;
    wave.counts = {3, 2, 4, 0};
    wave.numbers.clear();
    for (int i = 0; i < 24; ++i) {
        wave.numbers.push_back(i * 1e-9);
    }
    wave.layerLabels = {"", "HeightTrace", "HeightRetrace", "PhaseTraceMod1", "UserIn0Retrace"};
    wave.note += "UserIn0Unit: nA\r";
    wave.footer = "previews IsImage:1;IsARDF:0; 0506 MFP3D";
    return wave;
}

}  // namespace

TEST(IgorReader, FirstStoredRowIsTheBottomOfTheImage) {
    const ScanChannel channel = igorChannel({});
    const HeightMap& map = channel.map;
    ASSERT_EQ(map.columns, 3);
    ASSERT_EQ(map.rows, 2);
    EXPECT_DOUBLE_EQ(map.at(0, 0), 4.0);
    EXPECT_DOUBLE_EQ(map.at(0, 2), 6.0);
    EXPECT_DOUBLE_EQ(map.at(1, 0), 1.0);
    EXPECT_DOUBLE_EQ(map.sizeX(), 3e-9);
    EXPECT_DOUBLE_EQ(map.sizeY(), 4e-9);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.lateralUnit, "m");
    EXPECT_EQ(channel.name, "wave0");
}

TEST(IgorReader, ReadsEveryTypeInBothByteOrders) {
    const struct {
        int code;
        SampleType type;
    } types[] = {{0x02, SampleType::Float32}, {0x04, SampleType::Float64},
                 {0x08, SampleType::Int8},    {0x10, SampleType::Int16},
                 {0x20, SampleType::Int32},   {0x48, SampleType::UInt8},
                 {0x50, SampleType::UInt16},  {0x60, SampleType::UInt32},
                 {0x80, SampleType::Int64},   {0xc0, SampleType::UInt64}};
    for (const auto& type : types) {
        for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
            SCOPED_TRACE(type.code);
            IgorWaveText wave;
            wave.order = order;
            wave.type = type.code;
            wave.stored = type.type;
            wave.numbers = {100, 2, 3, 4, 5, 120};
            const HeightMap map = igorChannel(wave).map;
            EXPECT_DOUBLE_EQ(map.at(1, 0), 100.0);
            EXPECT_DOUBLE_EQ(map.at(0, 2), 120.0);
        }
    }
}

TEST(IgorReader, LayersTakeTheLabelAfterThatOfTheirDimension) {
    const HeightMapFile file = readAsIgor(igorFile(asylumWave()));
    ASSERT_EQ(file.channels.size(), 4U);
    EXPECT_EQ(file.channels[0].name, "HeightTrace");
    EXPECT_EQ(file.channels[0].direction, "forward");
    EXPECT_EQ(file.channels[1].name, "HeightRetrace");
    EXPECT_EQ(file.channels[1].direction, "backward");
    EXPECT_DOUBLE_EQ(file.channels[1].map.at(1, 0), 6e-9F);
}

TEST(IgorReader, UnitsFollowTheNoteAndTheNamesNotTheWave) {
    const HeightMapFile file = readAsIgor(igorFile(asylumWave()));
    EXPECT_EQ(file.channels.at(0).unit, "m");
    EXPECT_EQ(file.channels.at(2).unit, "deg");
    EXPECT_EQ(file.channels.at(3).unit, "A");
    IgorWaveText wave = asylumWave();
    wave.layerLabels[4] = "AdhesionTrace";
    EXPECT_EQ(readAsIgor(igorFile(wave)).channels.at(3).unit, "");
}

TEST(IgorReader, RetraceIsTheDefaultOfAnAsylumFile) {
    EXPECT_EQ(readAsIgor(igorFile(asylumWave())).defaultChannel, 1U);
}

TEST(IgorReader, LayersWithoutLabelsAreNumbered) {
    IgorWaveText wave = asylumWave();
    wave.layerLabels = {"layers"};
    wave.footer.clear();
    const HeightMapFile file = readAsIgor(igorFile(wave));
    EXPECT_EQ(file.channels.at(0).name, "wave0 0");
    EXPECT_EQ(file.channels.at(3).name, "wave0 3");
    EXPECT_EQ(file.channels.at(3).unit, "m");
}

TEST(IgorReader, NoteBecomesMetadataWhoseFirstEntryCounts) {
    const ScanChannel channel = igorChannel({});
    EXPECT_EQ(channel.metadata.at("ScanAngle"), "30\u00B0");
    EXPECT_EQ(channel.metadata.at("ScanSize"), "3e-09");
}

TEST(IgorReader, WaveWithoutUnitsIsNoHeight) {
    IgorWaveText wave;
    wave.unit.clear();
    wave.dimensionUnit.clear();
    const ScanChannel channel = igorChannel(wave);
    EXPECT_EQ(channel.unit, "");
    EXPECT_FALSE(channel.hasSize());
}

TEST(IgorReader, NumbersThatAreNoneHoldNoData) {
    IgorWaveText wave;
    wave.numbers[4] = std::numeric_limits<double>::quiet_NaN();
    const HeightMap map = igorChannel(wave).map;
    EXPECT_TRUE(std::isnan(map.at(0, 1)));
    EXPECT_TRUE(map.invalid[1]);
}

TEST(IgorReader, SizeThatIsNoneIsUnknown) {
    IgorWaveText wave;
    wave.steps[0] = std::numeric_limits<double>::quiet_NaN();
    const ScanChannel channel = igorChannel(wave);
    EXPECT_FALSE(channel.hasSize());
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("no lateral size")));
}

TEST(IgorReader, ForceCurvesAreNamedAsSuch) {
    IgorWaveText wave;
    wave.counts = {2, 3, 0, 0};
    wave.columnLabels = {"", "Raw", "Defl", "ZSnsr"};
    EXPECT_THAT(refusalOfIgor(igorFile(wave)),
                HasSubstr("force curves (Raw, Defl, ZSnsr), no image"));
    wave.columnLabels.clear();
    wave.footer = "IsImage:0;IsForce:1; 0298 Force";
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("force curves"));
}

TEST(IgorReader, RealForceCurvesAreNamedAsSuch) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const char* name : {"fmt-igor-fd_U3_3_p10004.ibw", "fmt-igor-fd_SiN_FD_plot.ibw"}) {
        const auto path = sharedData("curves/original") / name;
        EXPECT_THAT(refusalOf([&] { (void)readHeightMapFile(path); }),
                    AllOf(HasSubstr(name), HasSubstr("force curves (Raw, Defl, ZSnsr), no image")));
    }
}

TEST(IgorReader, OneDimensionIsACurve) {
    IgorWaveText wave;
    wave.counts = {6, 0, 0, 0};
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("a curve, no image"));
    std::string old(126, '\0');  // version 2 of no numbers
    old[0] = 2;
    old[2] = 110;  // bytes of the wave
    old[16] = 2;   // float32
    old[14] = static_cast<char>(-(2 + 110 + 2));
    old[15] = static_cast<char>(-1);  // the sum of all is 0
    EXPECT_THAT(refusalOfIgor(old), HasSubstr("one dimension: a curve, no image"));
}

TEST(IgorReader, TextsAndComplexNumbersAreRefused) {
    IgorWaveText wave;
    wave.type = 0;
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("texts"));
    wave.type = 3;
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("complex"));
    wave.type = 6;
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("code 6"));
}

TEST(IgorReader, WrongChecksumIsDamage) {
    std::string bytes = igorFile({});
    bytes[100] = 'x';
    EXPECT_THAT(refusalOfIgor(bytes), AllOf(HasSubstr("wave.ibw: header"), HasSubstr("checksum")));
}

TEST(IgorReader, DimensionsMustBeThoseOfTheNumbers) {
    IgorWaveText wave;
    wave.numberOfNumbers = 5;
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("3 x 2 x 0 x 0"));
    wave.numberOfNumbers = 6;
    wave.counts = {2000000000, 2000000000, 2000000000, 2000000000};
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("are not those of 6 numbers"));
    wave.counts = {-3, -2, 0, 0};
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("-3 x -2"));
}

TEST(IgorReader, FourDimensionsAndManyLayersAreRefused) {
    IgorWaveText wave;
    wave.counts = {1, 1, 3, 2};
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("3 x 2"));
    wave.counts = {1, 1, 129, 0};
    wave.numbers.assign(129, 1.0);
    EXPECT_THAT(refusalOfIgor(igorFile(wave)), HasSubstr("at most 128 layers"));
}

/// A wave of another program may hold heights, but steps in whatever it counts.
TEST(IgorReader, StepsWithoutAUnitAreNoMeters) {
    IgorWaveText wave;
    wave.dimensionUnit = "";
    const ScanChannel channel = readHeightMapBytes(igorFile(wave), "wave.ibw").channels.at(0);
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.map.pitchX, 0.0);
}

TEST(IgorReader, TrailingBytesAreNormalButNotACutAsylumFooter) {
    IgorWaveText plain;
    plain.footer = "anything";
    EXPECT_NO_THROW((void)igorChannel(plain));
    IgorWaveText asylum = asylumWave();
    asylum.footer = "previews IsImage:1;IsARDF:0; 05";
    EXPECT_THAT(readHeightMapBytes(igorFile(asylum), "wave.ibw").notes,
                testing::Contains(HasSubstr("'MFP3D'")));
}

TEST(IgorReader, WholeLayersOfATruncatedFileOpenWithANote) {
    const std::string bytes = igorFile(asylumWave());
    const HeightMapFile whole = readHeightMapBytes(bytes, "wave.ibw");
    const std::size_t first = 384 + 6 * 4;  // headers, and one layer of float32
    const HeightMapFile cut = readHeightMapBytes(bytes.substr(0, first + 1), "cut.ibw");
    ASSERT_EQ(cut.channels.size(), 1U);
    EXPECT_EQ(cut.channels[0].map.heights, whole.channels[0].map.heights);
    EXPECT_THAT(cut.notes, testing::Contains(HasSubstr("truncated")));
    EXPECT_THAT(refusalOfIgor(bytes.substr(0, first - 1)), HasSubstr("truncated"));
    const std::string single = igorFile({});
    EXPECT_THAT(refusalOfIgor(single.substr(0, single.size() - 1)), HasSubstr("truncated"));
}

}  // namespace asperity::test
