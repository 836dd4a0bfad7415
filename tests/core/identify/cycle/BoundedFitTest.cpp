#include "core/identify/cycle/BoundedFit.h"

#include "core/Random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

/// Residuals of a curve through noisy samples of y = 3 exp(-2 x), x = 0 .. 1.
template <typename Curve>
BoundedFit fitDecay(const std::vector<FreeParameter>& parameters, const Curve& curve) {
    constexpr int kCount = 200;
    std::vector<double> measured;
    Random random{5};
    for (int i = 0; i < kCount; ++i) {
        measured.push_back((3.0 * std::exp(-2.0 * i / kCount)) + (0.01 * random.normal()));
    }
    return fitWithin(
        parameters,
        [&](const std::vector<double>& values, Eigen::VectorXd& out) {
            for (int i = 0; i < kCount; ++i) {
                out[i] = curve(values, static_cast<double>(i) / kCount) -
                         measured[static_cast<std::size_t>(i)];
            }
        },
        kCount);
}

double decay(const std::vector<double>& values, double x) {
    return values[0] * std::exp(-values[1] * x);
}

TEST(BoundedFit, FindsLogarithmicAndLinearParameters) {
    const BoundedFit fit = fitDecay(
        {{"size", "N", 1.0, 1e-3, 1e3, 0.0}, {"rate", "1/s", 0.0, -10.0, 10.0, 1.0}}, decay);
    EXPECT_NEAR(fit.values[0], 3.0, 4.0 * fit.std(0));
    EXPECT_NEAR(fit.values[1], 2.0, 4.0 * fit.std(1));
    EXPECT_LT(fit.std(0), 0.02);
    EXPECT_TRUE(fit.notIdentified().empty());
    EXPECT_TRUE(fit.correlated().empty());
    EXPECT_EQ(fit.identified().at(1).unit, "1/s");
}

TEST(BoundedFit, ParameterAtItsBoundIsNotIdentified) {
    const BoundedFit fit =
        fitDecay({{"size", "", 1.0, 1e-3, 1e3, 0.0}, {"rate", "", 1.0, 0.5, 1.5, 0.0}}, decay);
    EXPECT_EQ(fit.values[1], 1.5);
    EXPECT_EQ(fit.notIdentified(), std::vector<std::string>{"rate"});
}

TEST(BoundedFit, ParameterWithoutEffectIsNotIdentified) {
    const BoundedFit fit = fitDecay({{"size", "", 1.0, 1e-3, 1e3, 0.0},
                                     {"rate", "", 1.0, 1e-3, 1e3, 0.0},
                                     {"nothing", "", 1.0, 1e-3, 1e3, 0.0}},
                                    decay);
    EXPECT_EQ(fit.notIdentified(), std::vector<std::string>{"nothing"});
}

TEST(BoundedFit, NamesParametersThatTheDataCannotTellApart) {
    const BoundedFit fit =
        fitDecay({{"rate", "", 1.0, 1e-3, 1e3, 0.0}, {"bend", "", 0.0, -10.0, 10.0, 1.0}},
                 [](const std::vector<double>& values, double x) {
                     return 3.0 * std::exp(-(values[0] * x) - (values[1] * std::pow(x, 1.3)));
                 });
    ASSERT_EQ(fit.correlated().size(), 1U);
    EXPECT_EQ(fit.correlated()[0].first, "rate");
    EXPECT_EQ(fit.correlated()[0].second, "bend");
    EXPECT_LT(fit.correlated()[0].correlation, -0.95);
}

}  // namespace
}  // namespace asperity
