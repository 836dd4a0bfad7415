#include "core/surface/HeightMoments.h"

#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace asperity {
namespace {

/// Waves of some 15 pixels, of odd size.
BSplineSurface wavySurface(int columns, int rows) {
    HeightMap map{.columns = columns, .rows = rows, .pitchX = 2.0_nm, .pitchY = 3.0_nm};
    for (int i = 0; i < columns * rows; ++i) {
        map.heights.push_back(100.0_nm + 5.0_nm * std::sin(0.4 * (i % columns)) +
                              3.0_nm * std::cos(0.5 * (i / columns)));
    }
    return fitSurface(std::move(map));
}

/// By 8 x 8 positions a pixel.
HeightSpread sampledSpread(const BSplineSurface& surface, int level, int row, int column) {
    constexpr int kFiner = 8;
    const int side = kFiner << static_cast<unsigned>(level);
    const double width = side * 2.0_nm / kFiner;
    const double height = side * 3.0_nm / kFiner;
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    double alongX = 0.0;
    double alongY = 0.0;
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const double x = ((k + 0.5) / side - 0.5) * width;
            const double y = ((i + 0.5) / side - 0.5) * height;
            const double above =
                surface.at((column + 0.5) * width + x, (row + 0.5) * height + y).height - 100.0_nm;
            count += 1.0;
            sum += above;
            squares += above * above;
            alongX += above * x;
            alongY += above * y;
        }
    }
    const double mean = sum / count;
    HeightSpread spread{.mean = 100.0_nm + mean,
                        .slopeX = 12.0 * alongX / count / (width * width),
                        .slopeY = 12.0 * alongY / count / (height * height),
                        .variance = 0.0};
    spread.variance =
        squares / count - mean * mean -
        (std::pow(width * spread.slopeX, 2) + std::pow(height * spread.slopeY, 2)) / 12.0;
    return spread;
}

TEST(HeightMoments, AreThePlaneNearestToEachBlockAndWhatIsLeft) {
    const BSplineSurface surface = wavySurface(45, 38);
    const HeightMoments moments(surface);
    for (const int level : {1, 2, 3, 4, 5}) {
        for (int row = 0; (row + 1) << static_cast<unsigned>(level) <= 38; ++row) {
            for (int column = 0; (column + 1) << static_cast<unsigned>(level) <= 45; ++column) {
                const HeightSpread found = moments.at(level, row, column);
                const HeightSpread exact = sampledSpread(surface, level, row, column);
                SCOPED_TRACE(testing::Message() << level << ' ' << row << ' ' << column);
                EXPECT_NEAR(found.mean, exact.mean, 0.01_nm);
                EXPECT_NEAR(found.slopeX, exact.slopeX, 0.01);
                EXPECT_NEAR(found.slopeY, exact.slopeY, 0.01);
                EXPECT_NEAR(found.variance, exact.variance,
                            0.03 * exact.variance + 0.01 * 1.0_nm * 1.0_nm);
            }
        }
    }
}

TEST(HeightMoments, BeyondTheScanAreThoseOfTheNearestBlock) {
    const HeightMoments moments(wavySurface(40, 24));
    EXPECT_EQ(moments.at(2, -3, 4).mean, moments.at(2, 0, 4).mean);
    EXPECT_EQ(moments.at(2, 17, 25).mean, moments.at(2, 5, 9).mean);
    EXPECT_EQ(moments.at(2, 17, 25).variance, moments.at(2, 5, 9).variance);
    EXPECT_EQ(moments.at(20, -1, 3).mean, moments.at(6, 0, 0).mean) << "the whole scan";
}

TEST(HeightMoments, OfASinglePixelAreItsHeight) {
    HeightMap map{.columns = 1, .rows = 1, .pitchX = 2.0_nm, .pitchY = 2.0_nm, .heights = {7.0_nm}};
    const HeightMoments moments(fitSurface(std::move(map)));
    EXPECT_NEAR(moments.at(1, 0, 0).mean, 7.0_nm, 1e-15);
    EXPECT_EQ(moments.at(3, 2, -1).variance, 0.0);
}

}  // namespace
}  // namespace asperity
