#include "core/identify/LeastSquares.h"

#include "core/Random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using Eigen::VectorXd;

constexpr std::size_t kCount = 500;

/// y = p0 exp(-x / p1) with errors.
struct Decay {
    VectorXd x = VectorXd::LinSpaced(kCount, 0.0, 4e-6);
    VectorXd y = 3e-9 * (-x / 1e-6).array().exp().matrix();

    [[nodiscard]] FitResult fit() const {
        VectorXd start(2);
        start << 1e-9, 4e-7;
        VectorXd scale(2);
        scale << 1e-9, 1e-7;
        return leastSquares(
            [this](const VectorXd& p, VectorXd& r) {
                r = (p[0] * (-x.array() / p[1]).exp()).matrix() - y;
            },
            start, scale, kCount);
    }
};

TEST(NonlinearLeastSquares, FindsTheParameters) {
    const FitResult fit = Decay().fit();
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.parameters[0], 3e-9, 3e-16);
    EXPECT_NEAR(fit.parameters[1], 1e-6, 1e-13);
}

TEST(NonlinearLeastSquares, StatesTheScatterOfItsResults) {
    Random random(7);
    double squares = 0.0;
    double stated = 0.0;
    constexpr int kSeeds = 200;
    for (int seed = 0; seed < kSeeds; ++seed) {
        Decay decay;
        for (double& value : decay.y) {
            value += 1e-10 * random.normal();
        }
        const FitResult fit = decay.fit();
        squares += std::pow(fit.parameters[1] - 1e-6, 2) / kSeeds;
        stated += fit.std(1) / kSeeds;
    }
    EXPECT_NEAR(stated, std::sqrt(squares), 0.15 * stated);
}

TEST(NonlinearLeastSquares, SaysWhatIsUndetermined) {
    VectorXd start(2);
    start << 1.0, 1.0;
    const FitResult fit = leastSquares(
        [](const VectorXd& p, VectorXd& r) {
            for (Eigen::Index i = 0; i < r.size(); ++i) {
                r[i] = p[0] + p[1] - 3.0 + (i % 2 == 0 ? 1e-3 : -1e-3);
            }
        },
        start, VectorXd::Ones(2), 20);
    EXPECT_NEAR(fit.parameters.sum(), 3.0, 1e-9);
    EXPECT_GT(fit.std(0), 1.0);
    EXPECT_NEAR(fit.correlation(0, 1), -1.0, 1e-6);
}

TEST(NonlinearLeastSquares, CountsErrorsThatAreAlike) {
    Random random(3);
    VectorXd white(20000);
    VectorXd slow(20000);
    double error = 0.0;
    for (Eigen::Index i = 0; i < white.size(); ++i) {
        white[i] = random.normal();
        error = (0.8 * error) + random.normal();
        slow[i] = error;
    }
    EXPECT_NEAR(autocorrelationFactor(white), 1.0, 0.1);
    EXPECT_NEAR(autocorrelationFactor(slow), 9.0, 1.0);  // (1 + 0.8) / (1 - 0.8)
}

}  // namespace
}  // namespace asperity
