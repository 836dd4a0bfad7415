#include "core/scene/RadialTable.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

TEST(RadialTable, FollowsAFunctionWithACuspAtTheRim) {
    constexpr double kRim = 5.0_nm;
    const auto function = [](double r) {
        return r < kRim ? 1.0_nm - r * r / 30.0_nm : 0.2_nm / std::sqrt(1.0 + (r - kRim) / 1.0_nm);
    };
    const RadialTable table(function, kRim, 60.0_nm);
    for (int step = 0; step < 850; ++step) {
        const double r = 0.07_nm * step;
        EXPECT_NEAR(table.at(r), function(r), 2e-3 * 1.0_nm) << r;
    }
    EXPECT_DOUBLE_EQ(table.at(100.0_nm), function(60.0_nm));
}

TEST(RadialTable, NeedsNoRim) {
    const RadialTable table([](double r) { return r; }, 0.0, 1.0);
    EXPECT_NEAR(table.at(0.5), 0.5, 1e-4);
    EXPECT_DOUBLE_EQ(table.at(0.0), 0.0);
}

}  // namespace
}  // namespace asperity
