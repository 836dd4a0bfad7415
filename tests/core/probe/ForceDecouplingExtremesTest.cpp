#include "core/Random.h"
#include "core/Units.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/probe/DecouplingSituations.h"
#include "tests/support/AllocationCounter.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <rapidcheck.h>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;
using test::referenceLever;
using test::Situation;
using test::slidingSituation;

/// Any direction of normal and motion, from standing still to a meter a second, any size of force.
TEST(ForceDecouplingExtremes, HasAPositiveDefiniteCovarianceAtTheExtremes) {
    EXPECT_TRUE(rc::check([] {
        const auto direction = [] {
            Random random(*rc::gen::arbitrary<std::uint64_t>());
            return Vector3(random.normal(), random.normal(), random.normal()).normalized();
        };
        CantileverGeometry geometry = referenceLever("G1_k14");
        geometry.mountTilt = *test::fraction() * 0.5;
        geometry.azimuth = *test::fraction() * 2.0 * pi;
        const double load = *test::logUniform(1e-15, 1e-4);
        DecouplingInput input;
        input.signals = {load * 700.0 * (*test::fraction() - 0.5), 1e-7 * *test::fraction()};
        input.sigma = {*test::logUniform(1e-11, 1e-4), *test::logUniform(1e-11, 1e-4)};
        input.normal = *test::logUniform(1e-20, 1e10) * direction();
        input.velocity = *test::logUniform(1e-25, 1.0) * direction();
        input.frictionCoefficient = 10.0 * *test::fraction();
        input.normalForceModel = load * (*test::fraction() - 0.3);
        input.normalForceSigma = *test::logUniform(1e-13, 1e-6);
        const ForceEstimate estimate = estimateForce(Cantilever(geometry), input);
        RC_ASSERT(estimate.kind != DecouplingCase::InvalidInput);
        RC_ASSERT(estimate.force.allFinite());
        RC_ASSERT(estimate.covariance == estimate.covariance.transpose());
        // Definite up to rounding, which is relative to the variances of the three directions.
        const Vector3 deviations = estimate.covariance.diagonal().cwiseSqrt();
        RC_ASSERT(deviations.minCoeff() > 0.0);
        const Vector3 inverse = deviations.cwiseInverse();
        const Matrix3 correlation =
            inverse.asDiagonal() * estimate.covariance * inverse.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(correlation);
        RC_ASSERT(spectrum.eigenvalues().minCoeff() > -1e-14);
    }));
}

TEST(ForceDecouplingExtremes, DoesNotCareHowLongTheNormalIs) {
    Situation situation = slidingSituation(Vector3(0.2, 0.1, 1.0), Vector3(1e-6, 3e-6, 0.0));
    const Vector3 expected = estimateForce(situation.lever, situation.input).force;
    const Vector3 normal = situation.input.normal;
    for (const double length : {1e-29, 0.5, 1e11}) {
        situation.input.normal = length * normal;
        const Vector3 force = estimateForce(situation.lever, situation.input).force;
        EXPECT_LE((force - expected).norm(), 1e-12 * expected.norm());
    }
}

/// A velocity of denormal size is rest; no arithmetic overflows on it.
TEST(ForceDecouplingExtremes, TakesADenormalVelocityAsRest) {
    Situation situation = slidingSituation(Vector3::UnitZ(), Vector3(1e-6, 0.0, 0.0));
    situation.input.velocity = Vector3::Zero();
    const Vector3 rest = estimateForce(situation.lever, situation.input).force;
    for (const double speed : {5e-324, 1e-310, 1e-200, 1e-40}) {
        situation.input.velocity = Vector3(speed, -speed, 0.0);
        const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
        EXPECT_EQ(estimate.kind, DecouplingCase::NoSliding);
        EXPECT_EQ(estimate.force, rest);
    }
}

/// A force along the blind direction gives no signal: only the contact model knows of it.
TEST(ForceDecouplingExtremes, LeavesABlindForceToTheModel) {
    const Vector3 blind = Vector3(1.0, 0.0, -0.16).normalized();
    Situation situation = slidingSituation(blind, Vector3(0.0, 1e-6, 0.0));
    situation.input.frictionCoefficient = 0.0;
    situation.force = 20_nN * blind;
    situation.input.signals = leverSignals(situation.lever, situation.force);
    EXPECT_NEAR(situation.input.signals.bending, 0.0, 1e-20);
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_LE((estimate.force - situation.force).norm(), 1e-3_nN);
    EXPECT_NEAR(std::sqrt(blind.dot(estimate.covariance * blind)), 4_nN, 0.01_nN);
}

TEST(ForceDecouplingExtremes, RefusesInputThatIsNoMeasurement) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Situation good = slidingSituation(Vector3::UnitZ(), Vector3(1e-6, 1e-6, 0.0));
    std::vector<DecouplingInput> inputs;
    const auto broken = [&](auto&& breakIt) {
        inputs.push_back(good.input);
        breakIt(inputs.back());
    };
    for (const double bad : {nan, infinity, -infinity, 1e300}) {
        broken([bad](DecouplingInput& in) { in.signals.bending = bad; });
        broken([bad](DecouplingInput& in) { in.signals.torsion = bad; });
        broken([bad](DecouplingInput& in) { in.normal.x() = bad; });
        broken([bad](DecouplingInput& in) { in.velocity.y() = bad; });
        broken([bad](DecouplingInput& in) { in.normalForceModel = bad; });
    }
    for (const double bad : {nan, infinity, -1.0, 0.0, 1e-300}) {
        broken([bad](DecouplingInput& in) { in.sigma.bending = bad; });
        broken([bad](DecouplingInput& in) { in.sigma.torsion = bad; });
        broken([bad](DecouplingInput& in) { in.normalForceSigma = bad; });
    }
    for (const double bad : {nan, infinity, -1.0}) {
        broken([bad](DecouplingInput& in) { in.frictionCoefficient = bad; });
        broken([bad](DecouplingInput& in) { in.shearStrength = bad; });
        broken([bad](DecouplingInput& in) { in.contactArea = bad; });
    }
    for (const double tooShort : {0.0, 5e-324, 1e-200, 1e-31}) {
        broken([tooShort](DecouplingInput& in) { in.normal *= tooShort; });
    }
    for (const DecouplingInput& input : inputs) {
        const ForceEstimate estimate = estimateForce(good.lever, input);
        EXPECT_EQ(estimate.kind, DecouplingCase::InvalidInput);
        EXPECT_TRUE(estimate.force.isZero(0.0));
        EXPECT_TRUE(estimate.covariance.isZero(0.0));
        EXPECT_EQ(caseText(estimate), "invalid_input");
    }
}

TEST(ForceDecouplingExtremes, DoesNotAllocate) {
    const Situation situation = slidingSituation(Vector3(0.1, 0.2, 1.0), Vector3(1e-6, 1e-6, 0.0));
    Vector3 sum = Vector3::Zero();
    const std::size_t before = test::allocationCount();
    for (int i = 0; i < 1000; ++i) {
        sum += estimateForce(situation.lever, situation.input).force;
    }
    const std::size_t after = test::allocationCount();
    EXPECT_EQ(after, before);
    EXPECT_TRUE(sum.allFinite());
}

}  // namespace
}  // namespace asperity
