#include "core/io/heightmap/ChannelRows.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A .gwy file of 3 x 2 pixels in this unit.
struct Scan {
    std::vector<double> values;
    std::string unit = "m";
    double sizeX = 3e-6;
    double sizeY = 2e-6;

    [[nodiscard]] std::string bytes() const {
        return gwyFile(gwyComponent(
            "/0/data", gwyObjectBytes("GwyDataField",
                                      gwyInteger("xres", 3) + gwyInteger("yres", 2) +
                                          gwyNumber("xreal", sizeX) + gwyNumber("yreal", sizeY) +
                                          gwyUnit("si_unit_xy", "m") + gwyUnit("si_unit_z", unit) +
                                          gwyNumbers("data", values))));
    }
};

/// Results of each way of reading the same; empty when the scan is read.
std::string refusalOfScan(const Scan& scan) {
    const std::string bytes = scan.bytes();
    const MemoryBytes source(bytes, "scan.gwy");
    const HeightMapContents contents = contentsOf(source, {});
    std::string whole = refusalOf([&] { (void)readHeightMap(contents.stored.front(), source); });
    EXPECT_EQ(whole, refusalOf([&] { (void)readScanMap(contents.stored.front(), source); }));
    return whole;
}

}  // namespace

TEST(ChannelRows, RefuseAHeightBeyondAKilometer) {
    EXPECT_THAT(refusalOfScan({{0, 0, 0, 0, 7e300, 0}}),
                AllOf(HasSubstr("scan.gwy: channel 'Image 0': the pixel in column 1, row 1 "),
                      HasSubstr("is 7e+300 m; heights within 1 km")));
    EXPECT_THAT(refusalOfScan({{0, 0, -1000.1, 0, 0, 0}}), HasSubstr("column 2, row 0"));
    EXPECT_EQ(refusalOfScan({{1000, -1000, 0, 0, 0, 0}}), "");
    EXPECT_THAT(refusalOfScan({{0, 0, 0, 2, 0, 0}, "km"}), HasSubstr("column 0, row 1"));
}

TEST(ChannelRows, NoScaleMakesAHeightAPixelWithoutData) {
    // 1e300 Ym is infinite in meters.
    EXPECT_THAT(refusalOfScan({{0, 0, 0, 0, 0, 1e300}, "Ym"}), HasSubstr("column 2, row 1"));
    EXPECT_EQ(refusalOfScan({{1e-9, 0, 0, std::nan(""), 0, kInfinity}}), "");
    EXPECT_EQ(refusalOfScan({{1e-30, 0, 0, std::nan(""), 0, -kInfinity}, "Ym"}), "");
}

TEST(ChannelRows, RefuseHeightsThatAreAllLostInSinglePrecision) {
    EXPECT_THAT(refusalOfScan({{0, 1e-60, 2e-60, 0, 0, 0}}),
                AllOf(HasSubstr("column 1, row 0"), HasSubstr("stored as 1e-60")));
    EXPECT_THAT(refusalOfScan({{0, 0, 0, 0, 1e-310, std::nan("")}, "ym"}),
                HasSubstr("column 1, row 1"));
    EXPECT_EQ(refusalOfScan({{0, 1e-60, 2e-9, 0, 0, 0}}), "");
    EXPECT_EQ(refusalOfScan({{0, 0, 0, 0, 0, 0}}), "");
    EXPECT_EQ(refusalOfScan({{std::nan(""), 0, 0, 0, 0, 0}}), "");
}

TEST(ChannelRows, OtherValuesLieWithinSinglePrecision) {
    EXPECT_EQ(refusalOfScan({{1e38, 0, 0, 0, 0, 0}, "V"}), "");
    EXPECT_EQ(refusalOfScan({{1e-60, 0, 0, 0, 0, 0}, "V"}), "");
    EXPECT_THAT(refusalOfScan({{0, 1e39, 0, 0, 0, 0}, "V"}),
                HasSubstr("1e+39 V; that is beyond single"));
}

TEST(ChannelRows, RefusePixelsOfNoScan) {
    EXPECT_THAT(refusalOfScan({{1, 2, 3, 4, 5, 6}, "nm", 1e300, 2e-6}),
                HasSubstr("1e+300 m x 2e-06 m"));
    EXPECT_THAT(refusalOfScan({{1, 2, 3, 4, 5, 6}, "nm", 3e-6, 1e-300}),
                HasSubstr("pixels of 1 fm"));
    EXPECT_EQ(refusalOfScan({{1, 2, 3, 4, 5, 6}, "nm", 999.0, 2e-15}), "");
}

TEST(ChannelRows, RefuseAScaleThatIsNoNumber) {
    NanoscopeText text;
    text.zScale = "V [Sens. ZsensSens] (0.123 V/LSB) 1e300 YV";
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(nanoscopeFile(text), "scan.spm"); }),
                HasSubstr("the scale of its values is no finite number"));
}

}  // namespace asperity::test
