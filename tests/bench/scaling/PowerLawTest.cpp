#include "bench/scaling/PowerLaw.h"

#include "core/Error.h"

#include <gtest/gtest.h>

#include <array>

namespace asperity {
namespace {

TEST(PowerLaw, ComesBackFromItsOwnValues) {
    const std::array<double, 4> x{1.0, 2.0, 5.0, 200.0};
    const PowerLaw law{.factor = 3e-6, .exponent = 1.5};
    const std::array<double, 4> y{law.at(x[0]), law.at(x[1]), law.at(x[2]), law.at(x[3])};
    const PowerLaw found = fitPowerLaw(x, y);
    EXPECT_NEAR(found.exponent, 1.5, 1e-12);
    EXPECT_NEAR(found.factor, 3e-6, 1e-17);
}

TEST(PowerLaw, HasNoSlopeThroughEqualTimes) {
    const std::array<double, 3> x{1.0, 10.0, 100.0};
    const std::array<double, 3> y{2.0, 2.0, 2.0};
    EXPECT_NEAR(fitPowerLaw(x, y).exponent, 0.0, 1e-15);
}

TEST(PowerLaw, WeighsEachDecadeAlike) {
    const std::array<double, 3> x{1.0, 10.0, 100.0};
    const std::array<double, 3> y{1.0, 100.0, 100.0};  // logarithms 0, 2, 2
    const PowerLaw law = fitPowerLaw(x, y);
    EXPECT_NEAR(law.exponent, 1.0, 1e-12);
    EXPECT_NEAR(law.at(10.0), 21.5443469, 1e-6);  // 10^(4/3)
}

TEST(PowerLaw, RefusesWhatHasNoSlope) {
    const std::array<double, 2> rising{1.0, 2.0};
    const std::array<double, 2> same{3.0, 3.0};
    const std::array<double, 2> zero{0.0, 1.0};
    const std::array<double, 1> one{1.0};
    EXPECT_THROW((void)fitPowerLaw(same, rising), Error);
    EXPECT_THROW((void)fitPowerLaw(rising, zero), Error);
    EXPECT_THROW((void)fitPowerLaw(rising, one), Error);
    EXPECT_THROW((void)fitPowerLaw(one, one), Error);
    EXPECT_THROW((void)fitPowerLaw({}, {}), Error);
}

}  // namespace
}  // namespace asperity
