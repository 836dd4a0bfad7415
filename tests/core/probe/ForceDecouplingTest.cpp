#include "core/probe/ForceDecoupling.h"

#include "core/Random.h"
#include "core/Units.h"
#include "core/probe/PlanarForce.h"
#include "core/probe/Sliding.h"
#include "tests/core/contact/ContactCases.h"
#include "tests/core/probe/DecouplingSituations.h"
#include "tests/support/AllocationCounter.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <rapidcheck.h>
#include <string>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;
using test::inputOfRow;
using test::referenceLever;
using test::ReferenceTable;
using test::Situation;
using test::slidingSituation;
using test::tiltedLever;

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
        EXPECT_LE(relativeDifference(local, covarianceOfRow(table, row)), 1e-10);
        EXPECT_EQ(estimate.covariance, estimate.covariance.transpose());
    }
}

/// The rest of T11's columns: directions, forward signals and the solution of planarity alone.
TEST(ForceDecoupling, HasTheReferenceGeometryAndPlanarForce) {
    const ReferenceTable table = test::referenceTable("T11_decoupling.csv");
    std::map<std::string, int> categories;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "id"));
        const auto cell = [&](const char* column) { return table.number(row, column); };
        const std::string& category = table.text(row, "cat");
        ++categories[category];
        const Cantilever lever = tiltedLever(table.text(row, "geom"), cell("tilt"));
        const DecouplingInput input = inputOfRow(table, row);
        const Vector3 force = test::vectorOfRow(table, row, "F");
        const LeverSignals signals = leverSignals(lever, force);
        const double size = lever.bendingPerFz() * force.norm();
        EXPECT_NEAR(signals.bending, cell("alpha"), 1e-12 * size);
        EXPECT_NEAR(signals.torsion, cell("theta"), 1e-12 * size);

        const Sliding sliding = slidingOf(input.normal, input.velocity);
        EXPECT_NEAR(sliding.certainty, cell("g"), 1e-12 + 1e-7 * (category == "normal_motion"));
        if (category != "nonplanar") {
            const Vector3 expected = (cell("N") * input.normal) + (cell("T") * sliding.friction);
            EXPECT_LE((force - expected).norm(), 1e-12 * force.norm());
        }
        const double friction =
            (cell("mu") * cell("N")) + (input.shearStrength * input.contactArea);
        const bool slides = sliding.certainty > 0.0;
        EXPECT_NEAR(cell("T"), slides ? std::max(0.0, friction) : 0.0, 1e-12 * force.norm());

        const PlanarForce planar = planarForce(lever, input.signals, input.normal, input.velocity);
        if (!slides || std::isnan(cell("hFx"))) {
            EXPECT_TRUE(planar.singular);
        }
        if (std::isnan(cell("hFx"))) {
            continue;
        }
        const Vector3 hard = test::vectorOfRow(table, row, "hF");
        if (!slides) {
            // The table's plane is that of any tangent; it explains the signals as ours would.
            const LeverSignals again = leverSignals(lever, hard);
            EXPECT_NEAR(again.bending, cell("alpha"), 1e-10 * lever.bendingPerFz() * hard.norm());
            EXPECT_NEAR(again.torsion, cell("theta"), 1e-10 * lever.torsionPerFy() * hard.norm());
            continue;
        }
        EXPECT_FALSE(planar.singular);
        EXPECT_NEAR(planar.determinant, cell("d3"), 1e-14);
        EXPECT_NEAR(-planar.determinant, cell("det"), 1e-14);
        const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * cell("cond");
        EXPECT_LE((planar.force - hard).norm(), std::max(1e-10, rounding) * hard.norm());
    }
    EXPECT_EQ(categories.size(), 13U) << "every category of the table";
}

/// docs/physics.md 6.5 (b): with exact signals and exact planarity the soft estimate is the hard
/// one, whatever friction law and model say.
TEST(ForceDecoupling, BecomesThePlanarForceForExactSignals) {
    Situation situation = slidingSituation(Vector3(0.1, -0.2, 1.0), Vector3(2.0, 5.0, 0.0));
    situation.input.sigma = {1e-18, 1e-18};
    situation.input.normalForceModel = 15_nN;
    situation.input.normalForceSigma = 1e-3;
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    const PlanarForce planar = planarForce(situation.lever, situation.input.signals,
                                           situation.input.normal, situation.input.velocity);
    EXPECT_LE((planar.force - situation.force).norm(), 1e-12 * situation.force.norm());
    EXPECT_LE((estimate.force - planar.force).norm(), 0.02 * situation.force.norm());
}

TEST(ForceDecoupling, TellsWhereTheForceBendsTheTip) {
    const Situation situation = slidingSituation(Vector3(0.2, 0.1, 1.0), Vector3(1e-6, 3e-6, 0.0));
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_EQ(estimate.deflection, situation.lever.compliance() * estimate.force);
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

/// Any direction of normal and motion, from standing still to a metre a second, any size of force.
TEST(ForceDecoupling, HasAPositiveDefiniteCovarianceAtTheExtremes) {
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

TEST(ForceDecoupling, DoesNotCareHowLongTheNormalIs) {
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
TEST(ForceDecoupling, TakesADenormalVelocityAsRest) {
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
TEST(ForceDecoupling, LeavesABlindForceToTheModel) {
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
