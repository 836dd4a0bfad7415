#include "core/Units.h"
#include "core/deformation/ContactDeformation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

TEST(RadialTable, FollowsAFunctionWithACuspAtTheRim) {
    constexpr double kRim = 5.0_nm;
    const auto function = [](double r) {
        return r < kRim ? 1.0_nm - r * r / 30.0_nm : 0.2_nm / std::sqrt(1.0 + (r - kRim) / 1.0_nm);
    };
    const RadialTable table(function, kRim, 8.0_nm);
    for (int step = 0; step < 850; ++step) {
        const double r = 0.07_nm * step;
        EXPECT_NEAR(table.at(r), function(r), 1e-6_nm) << r;
    }
    EXPECT_NEAR(table.at(1.0), 0.0, 1e-4_nm) << "a meter away";
}

TEST(RadialTable, NeedsNoRim) {
    const RadialTable table([](double r) { return 1.0 / (1.0 + r); }, 0.0, 1.0);
    EXPECT_NEAR(table.at(0.5), 1.0 / 1.5, 1e-9);
    EXPECT_DOUBLE_EQ(table.at(0.0), 1.0);
}

}  // namespace
}  // namespace asperity
