#include "core/probe/ForceDecoupling.h"

#include "core/Random.h"
#include "core/Units.h"
#include "core/probe/ProbeSystem.h"
#include "tests/core/probe/DecouplingSituations.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <rapidcheck.h>
#include <string>

namespace asperity {
namespace {

using std::numbers::pi;
using test::inputOfRow;
using test::kSignalNoise;
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

/// docs/theory.md 6.5 (b): with exact signals and exact planarity the soft estimate is the hard
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

TEST(ForceDecoupling, ThePlanarEstimateHasTheVarianceOfTheSignalsAlone) {
    Situation situation = slidingSituation(Vector3(0.1, -0.2, 1.0), Vector3(2.0, 5.0, 0.0));
    situation.input.sigma = {2e-7, 3e-7};
    const ForceEstimate estimate = planarEstimate(situation.lever, situation.input);
    EXPECT_LE((estimate.force - situation.force).norm(), 1e-12 * situation.force.norm());
    EXPECT_EQ(estimate.deflection, situation.lever.compliance() * estimate.force);
    Matrix3 expected = Matrix3::Zero();
    for (double LeverSignals::*signal : {&LeverSignals::bending, &LeverSignals::torsion}) {
        DecouplingInput moved = situation.input;
        moved.signals.*signal += situation.input.sigma.*signal;
        const Vector3 by = planarEstimate(situation.lever, moved).force - estimate.force;
        expected += by * by.transpose();
    }
    EXPECT_LE((estimate.covariance - expected).norm(), 1e-6 * expected.norm());
}

/// Forces about normals that are off by their deviation, with signals that are exact: what the
/// planar estimate is off by is what its covariance says.
TEST(ForceDecoupling, ThePlanarEstimateKnowsTheNormalsDeviation) {
    constexpr int kDraws = 2000;
    constexpr double kDeviation = 0.01;
    const Vector3 normal = Vector3(0.1, -0.2, 1.0).normalized();
    const Vector3 velocity(2.0, 5.0, 0.0);
    const Vector3 first = normal.unitOrthogonal();
    const Vector3 second = normal.cross(first);
    Random random(14);
    Matrix3 products = Matrix3::Zero();
    Matrix3 stated = Matrix3::Zero();
    for (int i = 0; i < kDraws; ++i) {
        const Vector3 turn = kDeviation * (random.normal() * first + random.normal() * second);
        Situation situation = slidingSituation(normal + turn, velocity);
        situation.input.normal = normal;
        situation.input.sigma = {1e-15, 1e-15};
        situation.input.normalDeviation = kDeviation;
        const ForceEstimate estimate = planarEstimate(situation.lever, situation.input);
        const Vector3 error = estimate.force - situation.force;
        products += error * error.transpose() / kDraws;
        stated += estimate.covariance / kDraws;
    }
    EXPECT_LE((products - stated).norm(), 0.15 * stated.norm());
}

TEST(ForceDecoupling, ThePlanarEstimateFallsBackOnTheModelWhereItIsSingular) {
    Situation situation = slidingSituation(Vector3::UnitZ(), Vector3::UnitX());
    situation.input.normalForceModel = 12_nN;
    situation.input.normalForceSigma = 2_nN;
    const ForceEstimate estimate = planarEstimate(situation.lever, situation.input);
    EXPECT_EQ(estimate.kind, DecouplingCase::NearSingular);
    EXPECT_LE((estimate.force - Vector3(0.0, 0.0, 12_nN)).norm(), 1e-12 * 12_nN);
    EXPECT_NEAR(estimate.covariance(2, 2), std::pow(2_nN, 2), 1e-12 * std::pow(2_nN, 2));
    situation.input.velocity = Vector3::Zero();
    EXPECT_EQ(planarEstimate(situation.lever, situation.input).kind, DecouplingCase::NoSliding);
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

/// Measured in docs/theory.md 6.5: standard deviations in nN of a tip sliding at an angle to the
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

/// Without friction nothing but noise is expected in the torsion, and the law is certain of it.
TEST(ForceDecoupling, SaysWhereItFollowsAFrictionLawAgainstTheTorsion) {
    Situation situation = slidingSituation(Vector3::UnitZ(), 1e-6 * Vector3::UnitY());
    situation.input.frictionCoefficient = 0.0;
    const auto torsionOf = [&](double deviations) {
        situation.input.signals.torsion = deviations * kSignalNoise;
        return estimateForce(situation.lever, situation.input).plausibility;
    };
    EXPECT_TRUE(torsionOf(0.0).holds());
    EXPECT_TRUE(torsionOf(-4.0).holds());
    EXPECT_TRUE(torsionOf(-10.0).excessFriction);
    EXPECT_TRUE(torsionOf(10.0).excessFriction);
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

/// Every heading once round, on the flat, on slopes, on a wall and under a tilted lever.
TEST(ForceDecoupling, IsContinuousInEveryHeading) {
    const auto largestStep = [](const Cantilever& lever, const Vector3& normal) {
        const Vector3 along = normal.unitOrthogonal();
        const Vector3 across = normal.cross(along);
        Situation situation = slidingSituation(normal, along + 0.4 * across);
        situation.input.signals = leverSignals(lever, situation.force);
        double largest = 0.0;
        Vector3 before = Vector3::Zero();
        constexpr int kSteps = 60000;
        for (int i = 0; i <= kSteps; ++i) {
            const double heading = 2.0 * pi * i / kSteps;
            situation.input.velocity =
                1e-6 * (std::cos(heading) * along + std::sin(heading) * across);
            const Vector3 force = estimateForce(lever, situation.input).force;
            largest = i > 0 ? std::max(largest, (force - before).norm()) : largest;
            before = force;
        }
        return largest;
    };
    for (const double tilt : {0.0, 0.2}) {
        const Cantilever lever = tiltedLever("G1_k14", tilt);
        for (const Vector3& direction :
             {Vector3(0.0, 0.0, 1.0), Vector3(0.3, -0.2, 1.0), Vector3(0.4, 0.0, 1.0),
              Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(1.0, 0.0, -0.16)}) {
            EXPECT_LT(largestStep(lever, direction.normalized()), 0.05_nN) << direction.transpose();
        }
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

}  // namespace
}  // namespace asperity
