// Each number of ISO 25178-2 on shapes for which it has a closed form, within 2 %. The closed forms
// are of the shapes, not of their pixels, but for the step, which is a pixel wide.

#include "core/surface/measure/Roughness.h"
#include "core/surface/measure/Texture.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace asperity {
namespace {

constexpr double kIsoHeight = 20e-9;  // [m]
constexpr int kIsoSide = 512;         // [pixel]
constexpr double kIsoPitch = 2e-9;    // [m]
constexpr double kIsoWidth = kIsoSide * kIsoPitch;
constexpr double kIsoHalfTurn = std::numbers::pi;
constexpr double kIsoWithin = 0.02;  // relative error; of what is 0, of 1

/// A number by its name, none: it does not exist.
struct IsoNumber {
    std::string name;
    std::optional<double> value;
};

/// By position of a pixel's center, from the middle of the map [m].
std::vector<IsoNumber> isoNumbers(const std::function<double(double, double)>& height) {
    HeightMap map =
        flatMap({.columns = kIsoSide, .rows = kIsoSide, .sizeX = kIsoWidth, .sizeY = kIsoWidth});
    for (int row = 0; row < kIsoSide; ++row) {
        for (int column = 0; column < kIsoSide; ++column) {
            map.heights[map.index(row, column)] =
                height((column + 0.5) * kIsoPitch - 0.5 * kIsoWidth,
                       0.5 * kIsoWidth - (row + 0.5) * kIsoPitch);
        }
    }
    const HeightRows rows = rowsOf(map);
    const Roughness roughness = roughnessOf(rows, allPixels(rows));
    const Texture texture = textureOf(rows, allPixels(rows));
    return {{"Sa", roughness.sa},   {"Sq", roughness.sq},   {"Sz", roughness.sz},
            {"Sp", roughness.sp},   {"Sv", roughness.sv},   {"Ssk", roughness.ssk},
            {"Sku", roughness.sku}, {"Sdq", roughness.sdq}, {"Sdr", roughness.sdr},
            {"Sal", texture.sal},   {"Str", texture.str}};
}

void expectAll(const std::vector<IsoNumber>& measured, const std::vector<IsoNumber>& exact) {
    for (const IsoNumber& number : exact) {
        const auto found = std::ranges::find(measured, number.name, &IsoNumber::name);
        ASSERT_NE(found, measured.end()) << number.name;
        ASSERT_EQ(found->value.has_value(), number.value.has_value()) << number.name;
        if (number.value) {
            const double scale = *number.value == 0.0 ? 1.0 : std::abs(*number.value);
            EXPECT_NEAR(*found->value, *number.value, kIsoWithin * scale) << number.name;
        }
    }
}

/// Area of z = A sin(k x) over that of its base, less 1; m = A k.
double sineAreaRatio(double m) {
    const double root = std::sqrt(1.0 + m * m);
    return 2.0 / kIsoHalfTurn * root * std::comp_ellint_2(m / root) - 1.0;
}

TEST(IsoNumbers, OfASine) {
    const double k = 2.0 * kIsoHalfTurn / (64.0 * kIsoPitch);
    expectAll(isoNumbers([k](double x, double) { return kIsoHeight * std::sin(k * x); }),
              {{"Sa", 2.0 * kIsoHeight / kIsoHalfTurn},
               {"Sq", kIsoHeight / std::numbers::sqrt2},
               {"Sz", 2.0 * kIsoHeight},
               {"Sp", kIsoHeight},
               {"Sv", kIsoHeight},
               {"Ssk", 0.0},
               {"Sku", 1.5},
               {"Sdq", kIsoHeight * k / std::numbers::sqrt2},
               {"Sdr", sineAreaRatio(kIsoHeight * k)},
               {"Sal", std::acos(0.2) / k},
               {"Str", std::nullopt}});
}

/// Waves along x and y of equal amplitude. On an axis the autocorrelation is 0.2 where the cosine
/// along it is -0.6.
TEST(IsoNumbers, OfCrossedSines) {
    const double k = 2.0 * kIsoHalfTurn / (16.0 * kIsoPitch);
    const double low = k / 4.0;
    expectAll(isoNumbers([=](double x, double y) {
                  return kIsoHeight * (std::sin(k * x) + std::sin(low * y));
              }),
              {{"Sa", 8.0 * kIsoHeight / (kIsoHalfTurn * kIsoHalfTurn)},
               {"Sq", kIsoHeight},
               {"Sz", 4.0 * kIsoHeight},
               {"Sp", 2.0 * kIsoHeight},
               {"Sv", 2.0 * kIsoHeight},
               {"Ssk", 0.0},
               {"Sku", 2.25},
               {"Sdq", kIsoHeight * std::sqrt(0.5 * (k * k + low * low))},
               {"Sal", std::acos(-0.6) / k},
               {"Str", 0.25}});
}

/// Means over pairs of pixels: f(t W) = 1 - 2 t - 2 t^2, 0.2 at t = (sqrt(2.6) - 1) / 2.
TEST(IsoNumbers, OfAPlane) {
    const double slope = 0.3;
    expectAll(isoNumbers([=](double x, double) { return slope * x; }),
              {{"Sa", slope * kIsoWidth / 4.0},
               {"Sq", slope * kIsoWidth / std::sqrt(12.0)},
               {"Sz", slope * kIsoWidth},
               {"Sp", slope * kIsoWidth / 2.0},
               {"Sv", slope * kIsoWidth / 2.0},
               {"Ssk", 0.0},
               {"Sku", 1.8},
               {"Sdq", slope},
               {"Sdr", std::sqrt(1.0 + slope * slope) - 1.0},
               {"Sal", 0.5 * (std::sqrt(2.6) - 1.0) * kIsoWidth},
               {"Str", std::nullopt}});
}

/// On the disk of its base, without data around it.
TEST(IsoNumbers, OfACone) {
    const double radius = 0.5 * kIsoWidth;
    const double height = 0.4 * radius;
    expectAll(isoNumbers([=](double x, double y) {
                  const double share = std::hypot(x, y) / radius;
                  return share <= 1.0 ? height * (1.0 - share)
                                      : std::numeric_limits<double>::quiet_NaN();
              }),
              {{"Sa", 16.0 / 81.0 * height},
               {"Sq", height / std::sqrt(18.0)},
               {"Sz", height},
               {"Sp", 2.0 / 3.0 * height},
               {"Sv", 1.0 / 3.0 * height},
               {"Ssk", 0.4 * std::numbers::sqrt2},
               {"Sku", 2.4},
               {"Sdq", 0.4},
               {"Sdr", std::sqrt(1.16) - 1.0}});
}

/// Means over pairs of pixels: of those a distance l apart, l / (W - l) lie on both sides.
TEST(IsoNumbers, OfAStep) {
    const double steepness = kIsoHeight / kIsoPitch;
    expectAll(isoNumbers([](double x, double) { return x < 0.0 ? 0.0 : kIsoHeight; }),
              {{"Sa", 0.5 * kIsoHeight},
               {"Sq", 0.5 * kIsoHeight},
               {"Sz", kIsoHeight},
               {"Sp", 0.5 * kIsoHeight},
               {"Sv", 0.5 * kIsoHeight},
               {"Ssk", 0.0},
               {"Sku", 1.0},
               {"Sdq", steepness / std::sqrt(kIsoSide - 1.0)},
               {"Sdr", (std::sqrt(1.0 + steepness * steepness) - 1.0) / (kIsoSide - 1.0)},
               {"Sal", 2.0 / 7.0 * kIsoWidth},
               {"Str", std::nullopt}});
}

/// The autocorrelation of a step falls linearly from pixel to pixel, so that its length is exact.
TEST(IsoNumbers, TheAutocorrelationFallsToOneFifth) {
    const auto numbers = isoNumbers([](double x, double) { return x < 0.0 ? 0.0 : kIsoHeight; });
    const auto sal = std::ranges::find(numbers, std::string("Sal"), &IsoNumber::name);
    EXPECT_NEAR(sal->value.value(), 2.0 / 7.0 * kIsoWidth, 1e-4 * kIsoWidth);
}

}  // namespace
}  // namespace asperity
