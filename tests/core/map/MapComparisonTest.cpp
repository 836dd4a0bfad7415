#include "core/map/MapComparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kPixels = 1000;

double turn(int pixel) { return 2.0 * std::numbers::pi * pixel / kPixels; }

/// A whole number of waves: mean 0, mean square 1/2, and no correlation between different numbers.
std::vector<double> waves(int count, double mean, double amplitude) {
    std::vector<double> values;
    for (int i = 0; i < kPixels; ++i) {
        values.push_back(mean + amplitude * std::sin(count * turn(i)));
    }
    return values;
}

TEST(MapComparison, OfAMapWithItselfLeavesNothing) {
    const std::vector<double> map = waves(3, 20e-9, 4e-9);
    const MapComparison result = compareMaps(map, map);
    EXPECT_EQ(result.compared, map.size());
    EXPECT_EQ(result.correlation, 1.0);
    EXPECT_EQ(result.shareByLine, 1.0);
    EXPECT_EQ(result.shareAsPredicted, 1.0);
    EXPECT_EQ(result.slope, 1.0);
    EXPECT_NEAR(result.offset, 0.0, 1e-22);
    EXPECT_EQ(result.meanDifference, 0.0);
    EXPECT_EQ(result.rmsDifference, 0.0);
    EXPECT_LT(result.rmsResidual, 1e-22);
}

/// measured = a + b predicted + what is not correlated with it: all numbers have closed forms.
TEST(MapComparison, TakesALinearRelationAndTheRestApart) {
    constexpr double kOffset = 5e-9;
    constexpr double kSlope = 1.5;
    constexpr double kRest = 2e-9;  // amplitude
    constexpr double kAmplitude = 4e-9;
    const std::vector<double> predicted = waves(3, 20e-9, kAmplitude);
    const std::vector<double> rest = waves(7, 0.0, kRest);
    std::vector<double> measured;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        measured.push_back(kOffset + kSlope * predicted[i] + rest[i]);
    }
    const MapComparison result = compareMaps(predicted, measured);
    const double explained = kSlope * kSlope * kAmplitude * kAmplitude / 2.0;
    const double variance = explained + kRest * kRest / 2.0;
    const double difference =
        (kSlope - 1.0) * (kSlope - 1.0) * kAmplitude * kAmplitude / 2.0 + kRest * kRest / 2.0;
    EXPECT_NEAR(result.predictedMean, 20e-9, 1e-20);
    EXPECT_NEAR(result.measuredMean, 35e-9, 1e-20);
    EXPECT_NEAR(result.predictedDeviation, kAmplitude / std::numbers::sqrt2, 1e-20);
    EXPECT_NEAR(result.measuredDeviation, std::sqrt(variance), 1e-20);
    EXPECT_NEAR(result.slope, kSlope, 1e-12);
    EXPECT_NEAR(result.offset, kOffset, 1e-20);
    EXPECT_NEAR(result.rmsResidual, kRest / std::numbers::sqrt2, 1e-20);
    EXPECT_NEAR(result.correlation, std::sqrt(explained / variance), 1e-12);
    EXPECT_NEAR(result.shareByLine, explained / variance, 1e-12);
    EXPECT_NEAR(result.shareAsPredicted, 1.0 - difference / variance, 1e-12);
    EXPECT_NEAR(result.meanDifference, 15e-9, 1e-20);
    EXPECT_NEAR(result.rmsDifference, std::sqrt(difference + 15e-9 * 15e-9), 1e-20);
}

TEST(MapComparison, OfOppositeMapsHasANegativeCorrelation) {
    const MapComparison result = compareMaps(waves(3, 1.0, 1.0), waves(3, 1.0, -2.0));
    EXPECT_NEAR(result.correlation, -1.0, 1e-12);
    EXPECT_NEAR(result.slope, -2.0, 1e-12);
    EXPECT_NEAR(result.shareByLine, 1.0, 1e-12);
    EXPECT_NEAR(result.shareAsPredicted, 1.0 - 9.0 / 4.0, 1e-12);
}

TEST(MapComparison, LeavesOutPixelsWithoutData) {
    const std::vector<double> predicted{1.0, kNone, 3.0, kNone, 2.0, 4.0};
    const std::vector<double> measured{1.0, 2.0, kNone, kNone, 4.0, 7.0};
    const MapComparison result = compareMaps(predicted, measured);
    EXPECT_EQ(result.pixels, 6U);
    EXPECT_EQ(result.compared, 3U);
    EXPECT_EQ(result.withoutPrediction, 2U);
    EXPECT_EQ(result.withoutMeasurement, 2U);
    EXPECT_NEAR(result.measuredMean, 4.0, 1e-15);
    EXPECT_NEAR(result.predictedMean, 7.0 / 3.0, 1e-15);
}

TEST(MapComparison, OfAConstantMapHasNoCorrelation) {
    const std::vector<double> varies = waves(2, 1e-9, 1e-9);
    const std::vector<double> constant(varies.size(), 3e-9);
    const MapComparison flat = compareMaps(constant, varies);
    EXPECT_TRUE(flat.isPredictedConstant());
    EXPECT_TRUE(std::isnan(flat.correlation));
    EXPECT_TRUE(std::isnan(flat.slope));
    EXPECT_TRUE(std::isnan(flat.shareByLine));
    EXPECT_NEAR(flat.shareAsPredicted, 0.0, 1e-12);
    EXPECT_NEAR(flat.meanDifference, -2e-9, 1e-20);
    const MapComparison still = compareMaps(varies, constant);
    EXPECT_TRUE(still.isMeasuredConstant());
    EXPECT_TRUE(std::isnan(still.slope));
    EXPECT_TRUE(std::isnan(still.correlation));
    EXPECT_TRUE(std::isnan(still.shareByLine));
    EXPECT_TRUE(std::isnan(still.shareAsPredicted));
}

TEST(MapComparison, OfRoundingErrorsHasNoCorrelation) {
    const MapComparison result = compareMaps(waves(3, 20e-9, 1e-20), waves(3, 20e-9, 1e-9));
    EXPECT_TRUE(result.isPredictedConstant());
    EXPECT_TRUE(std::isnan(result.correlation));
}

TEST(MapComparison, NeedsThreePixels) {
    const MapComparison two = compareMaps(std::vector{1.0, 2.0}, std::vector{3.0, 9.0});
    EXPECT_EQ(two.compared, 2U);
    EXPECT_TRUE(std::isnan(two.correlation));
    EXPECT_NEAR(two.meanDifference, 4.5, 1e-15);
    const MapComparison none = compareMaps(std::vector{kNone}, std::vector{1.0});
    EXPECT_EQ(none.compared, 0U);
    EXPECT_TRUE(std::isnan(none.measuredMean));
}

const MapPlan kComparedPlan{.grid = {.columns = 40, .rows = 25},
                            .region = {10e-9, 20e-9, 90e-9, 60e-9},
                            .setpoint = 1e-9,
                            .quantities = {MapQuantity::Height, MapQuantity::AdhesionForce}};

/// Height and tilt of a sample on its stage, as large as the hills.
std::vector<double> tilted(const std::vector<double>& heights) {
    std::vector<double> values = heights;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Vector2 position =
            kComparedPlan.position(static_cast<int>(i) / 40, static_cast<int>(i) % 40);
        values[i] += 7e-9 + 0.1 * (position.x() - 10e-9) - 0.05 * (position.y() - 20e-9);
    }
    return values;
}

TEST(ComparedQuantity, OfAHeightLosesItsPlane) {
    const std::vector<double> predicted = waves(3, 1e-9, 4e-9);
    std::vector<double> measured = tilted(predicted);
    measured[17] = kNone;
    const ComparedQuantity result =
        compareQuantity(kComparedPlan, MapQuantity::Height, predicted, measured);
    ASSERT_TRUE(result.plane.has_value());
    EXPECT_NEAR(result.plane->slopeX, 0.1, 1e-12);
    EXPECT_NEAR(result.plane->slopeY, -0.05, 1e-12);
    EXPECT_NEAR(result.plane->at(0.0, 0.0), 7e-9, 1e-20);
    EXPECT_EQ(result.numbers.compared, predicted.size() - 1);
    EXPECT_NEAR(result.numbers.shareByLine, 1.0, 1e-12);
    EXPECT_LT(result.numbers.rmsDifference, 1e-20);
    EXPECT_NEAR(result.measured[500], result.predicted[500], 1e-20);
    EXPECT_TRUE(std::isnan(result.measured[17]));
}

/// The tilt of the prediction was added to the measured map, and explained 99 % of its noise.
TEST(ComparedQuantity, OfALevelNoiseNothingIsExplainedByATiltedPrediction) {
    const std::vector<double> predicted = tilted(waves(3, 0.0, 1e-12));
    const std::vector<double> measured = waves(17, 0.0, 1e-9);
    const ComparedQuantity result =
        compareQuantity(kComparedPlan, MapQuantity::Height, predicted, measured);
    EXPECT_LT(result.numbers.shareByLine, 0.1);
    EXPECT_LT(result.numbers.shareAsPredicted, 0.1);
    EXPECT_NEAR(result.predictedPlane->slopeX, 0.1, 1e-4);
    const ComparedQuantity flat =
        compareQuantity(kComparedPlan, MapQuantity::Height, tilted(waves(3, 0.0, 0.0)), measured);
    EXPECT_TRUE(flat.numbers.isPredictedConstant()) << "rounding is no relief";
}

TEST(ComparedQuantity, OfAHeightNeedsMorePixelsThanItsPlane) {
    std::vector<double> predicted(kPixels, kNone);
    for (const std::size_t i : {3U, 77U, 410U, 700U, 999U}) {
        predicted[i] = 1e-9 * static_cast<double>(i % 7);
    }
    const ComparedQuantity result =
        compareQuantity(kComparedPlan, MapQuantity::Height, predicted, waves(3, 1e-9, 4e-9));
    EXPECT_EQ(result.numbers.compared, 5U);
    EXPECT_TRUE(std::isnan(result.numbers.correlation));
}

TEST(ComparedQuantity, OfAForceStaysAsItIs) {
    const std::vector<double> predicted = waves(3, 1e-9, 4e-9);
    const std::vector<double> measured = tilted(predicted);
    const ComparedQuantity result =
        compareQuantity(kComparedPlan, MapQuantity::AdhesionForce, predicted, measured);
    EXPECT_FALSE(result.plane.has_value());
    EXPECT_EQ(result.measured, measured);
    EXPECT_NEAR(result.numbers.meanDifference, 7e-9 + 0.1 * 40e-9 - 0.05 * 20e-9, 1e-20);
}

TEST(ComparedQuantity, WithoutACommonPixelIsNoError) {
    const std::vector<double> none(kPixels, kNone);
    const ComparedQuantity result =
        compareQuantity(kComparedPlan, MapQuantity::Height, none, waves(3, 1e-9, 4e-9));
    EXPECT_EQ(result.numbers.compared, 0U);
    EXPECT_FALSE(result.plane.has_value());
}

}  // namespace
}  // namespace asperity
