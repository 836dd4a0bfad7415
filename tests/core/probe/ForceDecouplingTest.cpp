#include "core/probe/ForceDecoupling.h"

#include "core/Units.h"
#include "tests/core/probe/ReferenceLever.h"
#include "tests/support/AllocationCounter.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <rapidcheck.h>
#include <string>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;
using test::referenceLever;
using test::ReferenceTable;

constexpr double kSignalNoise = 1e-7;  // of T11 [rad]

Cantilever tiltedLever(const std::string& name, double tilt) {
    CantileverGeometry geometry = referenceLever(name);
    geometry.mountTilt = tilt;
    return Cantilever(geometry);
}

DecouplingInput inputOfRow(const ReferenceTable& table, std::size_t row) {
    DecouplingInput input;
    input.signals = {table.number(row, "alpha"), table.number(row, "theta")};
    input.sigma = {kSignalNoise, kSignalNoise};
    input.normal = test::vectorOfRow(table, row, "n");
    input.velocity = test::vectorOfRow(table, row, "v");
    input.frictionCoefficient = table.number(row, "mu_assumed");
    input.shearStrength = table.number(row, "tau");
    input.contactArea = table.number(row, "A");
    input.normalForceModel = table.number(row, "N_model");
    input.normalForceSigma = table.number(row, "sigma_N");
    return input;
}

Matrix3 covarianceOfRow(const ReferenceTable& table, std::size_t row) {
    Matrix3 covariance;
    covariance << table.number(row, "Cxx"), table.number(row, "Cxy"), table.number(row, "Cxz"),
        table.number(row, "Cxy"), table.number(row, "Cyy"), table.number(row, "Cyz"),
        table.number(row, "Cxz"), table.number(row, "Cyz"), table.number(row, "Czz");
    return covariance;
}

/// Largest difference of two covariances, each entry against the two variances that it belongs to.
double relativeDifference(const Matrix3& actual, const Matrix3& expected) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double size = std::sqrt(expected(i, i) * expected(j, j));
            largest = std::max(largest, std::abs(actual(i, j) - expected(i, j)) / size);
        }
    }
    return largest;
}

/// A tip that slides on a slope, with signals that belong to its force.
struct Situation {
    Cantilever lever;
    DecouplingInput input;
    Vector3 force = Vector3::Zero();
};

Situation slidingSituation(const Vector3& normal, const Vector3& velocity) {
    Situation situation{Cantilever(referenceLever("G1_k14")), {}};
    DecouplingInput& input = situation.input;
    input.sigma = {kSignalNoise, kSignalNoise};
    input.normal = normal.normalized();
    input.velocity = velocity;
    input.frictionCoefficient = 0.3;
    input.normalForceModel = 20_nN;
    input.normalForceSigma = 4_nN;
    const Vector3 tangential = velocity - (velocity.dot(input.normal) * input.normal);
    situation.force = 20_nN * (input.normal - (0.3 * tangential.normalized()));
    input.signals = leverSignals(situation.lever, situation.force);
    return situation;
}

TEST(ForceDecoupling, HasTheReferenceEstimateAndCovariance) {
    const ReferenceTable table = test::referenceTable("T11_decoupling.csv");
    ASSERT_EQ(table.rows(), 230U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "id"));
        const Cantilever lever = tiltedLever(table.text(row, "geom"), table.number(row, "tilt"));
        const ForceEstimate estimate = estimateForce(lever, inputOfRow(table, row));
        const Vector3 expected = test::vectorOfRow(table, row, "eF");
        EXPECT_LE((estimate.force - expected).norm(), 1e-11 * (expected.norm() + 1_pN));
        const Matrix3 local = lever.rotation() * estimate.covariance * lever.rotation().transpose();
        EXPECT_LE(relativeDifference(local, covarianceOfRow(table, row)), 1e-9);
        EXPECT_EQ(estimate.covariance, estimate.covariance.transpose());
    }
}

TEST(ForceDecoupling, NamesTheGeometryByTheReferenceCondition) {
    const ReferenceTable table = test::referenceTable("T11_decoupling.csv");
    int singular = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "id"));
        const Cantilever lever = tiltedLever(table.text(row, "geom"), table.number(row, "tilt"));
        const ForceEstimate estimate = estimateForce(lever, inputOfRow(table, row));
        const double expected = table.number(row, "cond");
        const std::string& category = table.text(row, "cat");
        if (category == "static" || category == "normal_motion") {
            EXPECT_EQ(estimate.kind, DecouplingCase::NoSliding);
            EXPECT_TRUE(std::isinf(estimate.condition));
            continue;
        }
        EXPECT_EQ(estimate.kind,
                  expected > 100.0 ? DecouplingCase::NearSingular : DecouplingCase::Regular);
        if (expected < 1e12) {
            // A determinant near zero keeps only what rounding leaves of it.
            EXPECT_NEAR(estimate.condition, expected, (1e-13 + 1e-15 * expected) * expected);
        } else {
            EXPECT_GE(estimate.condition, 1e12);
            ++singular;
        }
    }
    EXPECT_GT(singular, 15);
}

/// Measured in docs/physics.md 6.5: standard deviations in nN of a tip sliding at an angle to the
/// beam.
TEST(ForceDecoupling, SaysHowLittleItKnowsWhenSlidingAlongTheBeam) {
    struct Expected {
        double degrees;
        double sigmaX;
    };
    for (const auto& [degrees, sigmaX] :
         {Expected{0.0, 2.20}, Expected{30.0, 1.45}, Expected{60.0, 0.63}, Expected{90.0, 0.14}}) {
        const double angle = degrees * pi / 180.0;
        Situation situation = slidingSituation(
            Vector3::UnitZ(), 1e-6 * Vector3(std::cos(angle), std::sin(angle), 0.0));
        situation.input.shearStrength = 50_MPa;
        situation.input.contactArea = 2e-17;
        situation.input.normalForceSigma = 4.1_nN;
        const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
        EXPECT_NEAR(std::sqrt(estimate.covariance(0, 0)) / 1_nN, sigmaX, 0.006);
    }
}

TEST(ForceDecoupling, ReturnsTheTrueForceWhenAllAssumptionsHold) {
    EXPECT_TRUE(rc::check([] {
        const auto angle = [] { return *rc::gen::inRange(0, 3600) * pi / 1800.0; };
        const double slope = *rc::gen::inRange(0, 60) * pi / 180.0;
        const double downhill = angle();
        const double heading = angle();
        const Vector3 normal(std::sin(slope) * std::cos(downhill),
                             std::sin(slope) * std::sin(downhill), std::cos(slope));
        // Fast enough that rest has no weight left.
        const Vector3 velocity = 100.0 * Vector3(std::cos(heading), std::sin(heading), 0.0);
        const Situation situation = slidingSituation(normal, velocity);
        const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
        RC_ASSERT((estimate.force - situation.force).norm() <= 1e-9 * situation.force.norm());
    }));
}

/// Through the singular heading and through rest: no estimate jumps.
TEST(ForceDecoupling, IsContinuousThroughSingularHeadingsAndRest) {
    Situation situation = slidingSituation(Vector3(0.2, 0.1, 1.0), Vector3(1e-6, 3e-7, 0.0));
    Vector3 before = Vector3::Zero();
    for (int i = -20000; i <= 20000; ++i) {
        const double along = 1e-12 * i;
        situation.input.velocity = Vector3(0.3 * along, along, 0.0);
        const Vector3 force = estimateForce(situation.lever, situation.input).force;
        if (i > -20000) {
            EXPECT_LT((force - before).norm(), 0.02_nN) << i;
        }
        before = force;
    }
    for (int i = -2000; i <= 2000; ++i) {
        const double heading = 1e-3 * i;
        situation.input.velocity = 1e-6 * Vector3(std::cos(heading), std::sin(heading), 0.0);
        const Vector3 force = estimateForce(situation.lever, situation.input).force;
        if (i > -2000) {
            EXPECT_LT((force - before).norm(), 0.2_nN) << i;
        }
        before = force;
    }
}

TEST(ForceDecoupling, TurnsWithTheLever) {
    const Situation situation = slidingSituation(Vector3(0.2, -0.1, 1.0), Vector3(1e-6, 2e-6, 0.0));
    const ForceEstimate straight = estimateForce(situation.lever, situation.input);
    CantileverGeometry geometry = referenceLever("G1_k14");
    geometry.azimuth = 1.1;
    const Matrix3 turn = Eigen::AngleAxisd(1.1, Vector3::UnitZ()).toRotationMatrix();
    DecouplingInput turned = situation.input;
    turned.normal = turn * situation.input.normal;
    turned.velocity = turn * situation.input.velocity;
    const ForceEstimate estimate = estimateForce(Cantilever(geometry), turned);
    EXPECT_TRUE(estimate.force.isApprox(turn * straight.force, 1e-11));
    EXPECT_TRUE(estimate.covariance.isApprox(turn * straight.covariance * turn.transpose(), 1e-11));
}

/// Motion along the normal has no tangential direction, only rounding noise.
TEST(ForceDecoupling, TakesNoDirectionFromMotionAlongTheNormal) {
    const Vector3 normal = Vector3(0.3, 0.4, 1.2).normalized();
    for (const Vector3& velocity :
         {Vector3(1e-6 * normal), Vector3(-normal), Vector3(0.0, 0.0, 0.0)}) {
        Situation situation = slidingSituation(normal, Vector3(1e-6, 0.0, 0.0));
        situation.input.velocity = velocity;
        const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
        EXPECT_EQ(estimate.kind, DecouplingCase::NoSliding);
        EXPECT_TRUE(estimate.force.allFinite());
        // No friction known: the tangential force is 0 within mu N.
        const double tangential = (estimate.force - (estimate.force.dot(normal) * normal)).norm();
        EXPECT_LT(tangential, 6_nN);
    }
}

TEST(ForceDecoupling, RefusesInputThatIsNoMeasurement) {
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
    broken([](DecouplingInput& in) { in.normal = Vector3::Zero(); });
    for (const DecouplingInput& input : inputs) {
        const ForceEstimate estimate = estimateForce(good.lever, input);
        EXPECT_EQ(estimate.kind, DecouplingCase::InvalidInput);
        EXPECT_TRUE(estimate.force.isZero(0.0));
        EXPECT_TRUE(estimate.covariance.isZero(0.0));
    }
}

TEST(ForceDecoupling, DoesNotAllocate) {
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
