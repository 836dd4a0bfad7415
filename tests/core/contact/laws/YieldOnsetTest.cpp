#include "core/Units.h"
#include "core/contact/laws/HertzLaw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// Difference of the principal stresses on the axis under Hertz' contact over its largest pressure,
/// at `x` contact radii below the surface. Source: Johnson, Contact Mechanics (1985), chapter 3.
double hertzShear(double x, double nu) {
    return 1.5 / (1.0 + (x * x)) - ((1.0 + nu) * (1.0 - (x * std::atan(1.0 / x))));
}

/// The same under a flat punch over the pressure in its middle: f - x f' by central differences.
double punchShear(double x, double nu) {
    constexpr double kStep = 1e-5;
    const double slope = (hertzShear(x + kStep, nu) - hertzShear(x - kStep, nu)) / (2.0 * kStep);
    return hertzShear(x, nu) - (x * slope);
}

template <class Shear>
double largest(const Shear& shear) {
    double most = 0.0;
    for (double x = 0.01; x < 2.0; x += 1e-4) {
        most = std::max(most, shear(x));
    }
    return most;
}

TEST(YieldOnset, IsWhereTheStressesUnderHertzReachTheYieldStress) {
    for (const double nu : {0.0, 0.17, 0.3, 0.4, 0.5}) {
        SCOPED_TRACE(nu);
        const double shear = largest([nu](double x) { return hertzShear(x, nu); });
        EXPECT_NEAR(yieldPressure(2.8_GPa, nu) * shear, 1.0_GPa, 0.004_GPa);
    }
    EXPECT_NEAR(yieldPressure(1.0_GPa, 0.3), 1.6 / 2.8 * 1.0_GPa, 0.01_GPa) << "Johnson's 1.60 Y";
    EXPECT_EQ(yieldPressure(0.0, 0.3), 0.0);
}

/// Hertz' pressure less a third of it as under a flat punch is JKR's contact without load.
TEST(YieldOnset, GoesByThePressureInTheMiddleUnderAdhesionToo) {
    const double nu = 0.3;
    const double hertz = largest([nu](double x) { return hertzShear(x, nu); });
    for (const double punch : {0.05, 0.1, 0.2, 1.0 / 3.0}) {
        SCOPED_TRACE(punch);
        const double both =
            largest([&](double x) { return hertzShear(x, nu) - (punch * punchShear(x, nu)); });
        const double byMiddle = (1.0 - punch) * hertz;
        EXPECT_GE(both, byMiddle * (1.0 - 1e-9));
        EXPECT_LT(both, 1.07 * byMiddle);
    }
}

}  // namespace
}  // namespace asperity
