#include "core/surface/fit/BSplineFit.h"

#include "core/Error.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/fit/SeparableFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ProgressRecorder.h"
#include "tests/support/ScanMaps.h"
#include "tests/support/StorageError.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

HeightMap roughMap(int columns, int rows) {
    HeightMap map = flatMap(
        {.columns = columns, .rows = rows, .sizeX = columns * 2.0_nm, .sizeY = rows * 3.0_nm});
    Random random(29);
    for (double& height : map.heights) {
        height = random.uniform(-5.0_nm, 5.0_nm);
    }
    return map;
}

/// From the samples of a line to the control heights of its spline, padding included: the
/// interpolation conditions and no third difference at either end.
Eigen::MatrixXd splineOfLine(int samples) {
    if (samples < 3) {  // a level or a straight line
        Eigen::MatrixXd straight = Eigen::MatrixXd::Zero(samples + 2, samples);
        for (int i = 0; i < samples + 2; ++i) {
            straight(i, 0) = samples == 1 ? 1.0 : 2.0 - i;
            if (samples == 2) {
                straight(i, 1) = i - 1.0;
            }
        }
        return straight;
    }
    Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(samples + 2, samples + 2);
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(samples + 2, samples);
    for (int i = 0; i < samples; ++i) {
        conditions.block<1, 3>(i + 1, i) << 1.0, 4.0, 1.0;
        values(i + 1, i) = 6.0;
    }
    conditions.block<1, 4>(0, 0) << 1.0, -3.0, 3.0, -1.0;
    conditions.block<1, 4>(samples + 1, samples - 2) << -1.0, 3.0, -3.0, 1.0;
    return conditions.partialPivLu().solve(values);
}

Eigen::MatrixXd splineOf(const HeightMap& map) {
    Eigen::MatrixXd samples(map.rows, map.columns);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            samples(map.rows - 1 - row, column) = map.at(row, column);
        }
    }
    return splineOfLine(map.rows) * samples * splineOfLine(map.columns).transpose();
}

void expectControls(const BSplineSurface& surface, const Eigen::MatrixXd& expected) {
    const double tolerance = test::storageErrorOf(surface).height + 1e-14 * surface.heightScale();
    for (int row = 0; row < expected.rows(); ++row) {
        for (int column = 0; column < expected.cols(); ++column) {
            ASSERT_NEAR(surface.control(row - 1, column - 1), expected(row, column), tolerance)
                << "row " << row << ", column " << column << " of " << expected.rows() << " x "
                << expected.cols();
        }
    }
}

TEST(BSplineFit, IsTheSplineOfTheSmoothedMap) {
    for (const double sigma : {0.0, 0.02, 0.3, 1.0, 1.5, 6.0}) {
        for (const auto& [columns, rows] :
             {std::pair{1, 1}, {1, 150}, {140, 1}, {2, 2}, {3, 5}, {40, 31}, {171, 145}}) {
            const HeightMap map = roughMap(columns, rows);
            expectControls(fitSurface(map, {sigma, sigma}), splineOf(smoothed(map, sigma)));
        }
    }
}

TEST(BSplineFit, SmoothesEachAxisByItsOwnWidth) {
    const HeightMap map = roughMap(160, 150);
    for (const Smoothing& smoothing : {Smoothing{.x = 3.0}, Smoothing{.x = 0.7, .y = 2.0}}) {
        expectControls(fitSurface(map, smoothing), splineOf(smoothed(map, smoothing)));
    }
}

TEST(BSplineFit, SmoothingLeavesAPlaneUnchangedUpToTheEdges) {
    HeightMap map = flatMap({.columns = 200, .rows = 90, .sizeX = 1.0_um, .sizeY = 1.0_um});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = 7.0_nm + column * 2.0_nm - row * 3.0_nm;
        }
    }
    for (const double sigma : {0.0, 1.0, 2.5, 40.0}) {
        const BSplineSurface surface = fitSurface(map, {sigma, sigma});
        // A smoothing reflects the map at its borders as often as its reach asks for; each time
        // rounding grows.
        const double reflections = 5.0 * sigma / map.rows;
        const double tolerance = (1.0 + reflections) * test::storageErrorOf(surface).height;
        for (int row = -1; row <= map.rows; ++row) {
            for (int column = -1; column <= map.columns; ++column) {
                const double plane = 7.0_nm + column * 2.0_nm - (map.rows - 1 - row) * 3.0_nm;
                ASSERT_NEAR(surface.control(row, column), plane, tolerance);
            }
        }
    }
}

TEST(BSplineFit, IsTheSameWithAnyInstructionsAndThreads) {
    const ScanMap map = test::singlePrecision(roughMap(1300, 150));
    for (const double sigma : {0.0, 1.5}) {
        const LineFit alongX(map.columns, sigma);
        const LineFit alongY(map.rows, sigma);
        const auto fit = [&](VectorUnit unit, int threads) {
            return separableFit(map, alongX, alongY, nullptr, {unit, threads});
        };
        const PixelVector<float> controls = fit(VectorUnit::Baseline, 1);
        EXPECT_TRUE(controls == fit(VectorUnit::Baseline, 3));
        EXPECT_TRUE(controls == fit(widestVectorUnit(), 1));
        EXPECT_TRUE(controls == fit(widestVectorUnit(), 2));
    }
}

TEST(BSplineFit, AWideSmoothingWorksOnShortLines) {
    const HeightMap map = roughMap(30, 20);
    const BSplineSurface surface = fitSurface(map, {kMaxSmoothing, kMaxSmoothing});
    expectControls(surface, splineOf(smoothed(map, kMaxSmoothing)));
}

TEST(BSplineFit, RefusesWidthsThatAreNoNumbers) {
    const HeightMap map = roughMap(4, 4);
    for (const double sigma : {-1.0, std::nan(""), 1e9}) {
        EXPECT_THROW((void)fitSurface(map, {.x = sigma}), Error);
        EXPECT_THROW((void)fitSurface(map, {.y = sigma}), Error);
    }
}

TEST(BSplineFit, TellsHowFarItIs) {
    test::ProgressRecorder recorder(2.0);
    (void)fitSurface(test::singlePrecision(roughMap(2100, 30)), {}, &recorder);
    ASSERT_GE(recorder.fractions.size(), 2U);
    EXPECT_TRUE(std::is_sorted(recorder.fractions.begin(), recorder.fractions.end()));
    EXPECT_EQ(recorder.fractions.front(), 0.0);
    EXPECT_EQ(recorder.fractions.back(), 1.0);
}

TEST(BSplineFit, EndsWhenItIsCanceled) {
    test::ProgressRecorder recorder(0.0);
    const ScanMap map = test::singlePrecision(roughMap(2100, 30));
    EXPECT_THROW((void)fitSurface(map, {}, &recorder), Canceled);
    EXPECT_EQ(recorder.fractions.size(), 1U);
}

TEST(BSplineFit, EndsWhenItIsCanceledWhileTwoThreadsFindTheBoundsOfCells) {
    test::ProgressRecorder recorder(0.6);
    const ScanMap map = test::singlePrecision(roughMap(600, 600));
    EXPECT_THROW((void)fitSurface(map, {}, &recorder), Canceled);
    EXPECT_LT(recorder.fractions.back(), 0.7);
}

}  // namespace
}  // namespace asperity
