#include "core/Random.h"
#include "core/probe/ProbeSystem.h"
#include "tests/core/probe/DecouplingSituations.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;

constexpr int kNoiseDraws = 10000;
constexpr double kStandardErrors = 5.0;

/// Where the tip touches and how it moves there.
struct NoisyTick {
    std::string name;
    double tilt = 0.0;
    double azimuth = 0.0;
    Vector3 normal = Vector3::UnitZ();
    Vector3 velocity = Vector3::Zero();
    double frictionCoefficient = 0.3;
    double normalForce = 20_nN;
};

Vector3 heading(double degrees, double speed = 1e-6) {
    return speed * Vector3(std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0), 0.0);
}

/// Regular positions, and every kind of singular one that docs/theory.md 6.3 names.
std::vector<NoisyTick> situations() {
    const Vector3 slope = Vector3(0.3, -0.2, 1.0).normalized();
    const Vector3 blind = Vector3(1.0, 0.0, -0.16).normalized();
    const double tilt = 12.0 * pi / 180.0;
    const auto flat = [](const std::string& name, const Vector3& velocity) {
        return NoisyTick{.name = name, .velocity = velocity};
    };
    return {
        flat("across the beam", heading(90.0)),
        flat("at 60 degrees", heading(60.0)),
        flat("at 30 degrees", heading(30.0)),
        flat("at 10 degrees", heading(-10.0)),
        flat("at 1 degree", heading(1.0)),
        flat("along the beam: singular", heading(0.0)),
        flat("back along the beam: singular", heading(180.0)),
        flat("at rest", Vector3::Zero()),
        flat("along the normal", 1e-6 * Vector3::UnitZ()),
        flat("as slow as v0", heading(45.0, 1e-9)),
        flat("slower than v0", heading(45.0, 1e-11)),
        {.name = "slope", .normal = slope, .velocity = heading(70.0)},
        {.name = "slope in the beam's plane: singular",
         .normal = Vector3(0.4, 0.0, 1.0).normalized(),
         .velocity = heading(0.0)},
        {.name = "hidden singular direction",
         .normal = slope,
         .velocity = 1e-6 * (blind - (blind.dot(slope) * slope)).normalized()},
        {.name = "upright wall", .normal = Vector3::UnitX(), .velocity = heading(90.0)},
        {.name = "upright wall beside", .normal = Vector3::UnitY(), .velocity = heading(0.0)},
        {.name = "blind force",
         .normal = blind,
         .velocity = 1e-6 * Vector3::UnitY(),
         .frictionCoefficient = 0.0},
        {.name = "tilted mount", .tilt = tilt, .velocity = heading(50.0)},
        {.name = "tilted and turned mount",
         .tilt = tilt,
         .azimuth = 0.8,
         .normal = slope,
         .velocity = heading(50.0)},
        {.name = "tilted mount, along the beam", .tilt = tilt, .velocity = heading(0.0)},
        {.name = "pulled", .velocity = heading(40.0), .normalForce = -3_nN},
        {.name = "no friction", .velocity = heading(40.0), .frictionCoefficient = 0.0},
    };
}

Cantilever leverAt(const NoisyTick& situation) {
    CantileverGeometry geometry = test::referenceLever("G1_k14");
    geometry.mountTilt = situation.tilt;
    geometry.azimuth = situation.azimuth;
    return Cantilever(geometry);
}

DecouplingInput inputAt(const NoisyTick& situation) {
    return {.signals = {},
            .sigma = {test::kSignalNoise, test::kSignalNoise},
            .normal = situation.normal,
            .velocity = situation.velocity,
            .frictionCoefficient = situation.frictionCoefficient,
            .shearStrength = 50_MPa,
            .contactArea = 2e-17,
            .normalForceModel = situation.normalForce,
            .normalForceSigma = 0.2 * std::abs(situation.normalForce) + 0.1_nN};
}

/// A world that departs from the estimator's assumptions by as much as the estimator takes them to
/// be off: defects of planarity, friction law and contact model decide the force, and the signals
/// come with noise. Lab frame; formulas of docs/theory.md 6.5, written once more.
class ImperfectWorld {
public:
    ImperfectWorld(const Cantilever& lever, const DecouplingInput& input)
        : lever_(lever), input_(input) {
        // Any tangent at rest: the one that the cantilever's frame gives.
        const Matrix3& rotation = lever.rotation();
        const Sliding sliding = slidingOf(rotation * input.normal, rotation * input.velocity);
        const Vector3 friction = rotation.transpose() * sliding.friction;
        const double g = sliding.certainty;
        const double adhesive = input.shearStrength * input.contactArea;
        const double scale =
            input.frictionCoefficient * std::abs(input.normalForceModel) + adhesive + 1e-12;
        rows_.row(0) = input.normal.cross(friction).transpose();
        rows_.row(1) = (friction - g * input.frictionCoefficient * input.normal).transpose();
        rows_.row(2) = input.normal.transpose();
        values_ = {0.0, g * adhesive, input.normalForceModel};
        sigmas_ = {scale * std::hypot(g * 0.02, sliding.doubt),
                   scale * std::hypot(g * 0.3, sliding.doubt), input.normalForceSigma};
    }

    /// One force of this world, and the input that a measurement of it gives.
    [[nodiscard]] Vector3 draw(Random& random, DecouplingInput& input) const {
        const Vector3 defects(random.normal(), random.normal(), random.normal());
        Vector3 force = rows_.partialPivLu().solve(values_ + sigmas_.cwiseProduct(defects));
        input = input_;
        input.signals = leverSignals(lever_, force);
        input.signals.bending += input_.sigma.bending * random.normal();
        input.signals.torsion += input_.sigma.torsion * random.normal();
        return force;
    }

private:
    const Cantilever& lever_;
    DecouplingInput input_;
    Matrix3 rows_;
    Vector3 values_;
    Vector3 sigmas_;
};

/// What the errors of many estimates say about the covariance that each reports.
struct Scatter {
    Vector3 mean = Vector3::Zero();
    Matrix3 products = Matrix3::Zero();
    double chiSquare = 0.0;  ///< mean of e^T C^-1 e
};

Scatter scatterOfErrors(const Cantilever& lever, const ImperfectWorld& world,
                        const Matrix3& covariance) {
    const Eigen::LLT<Matrix3> root(covariance);
    Scatter scatter;
    Random random(11);
    for (int i = 0; i < kNoiseDraws; ++i) {
        DecouplingInput input;
        const Vector3 force = world.draw(random, input);
        const ForceEstimate estimate = estimateForce(lever, input);
        EXPECT_EQ(estimate.covariance, covariance) << "does not depend on the signals";
        const Vector3 error = estimate.force - force;
        scatter.mean += error / kNoiseDraws;
        scatter.products += error * error.transpose() / kNoiseDraws;
        scatter.chiSquare += error.dot(root.solve(error)) / kNoiseDraws;
    }
    return scatter;
}

TEST(DecouplingNoise, ScattersAsTheReportedCovarianceSays) {
    ASSERT_GE(situations().size(), 20U);
    for (const NoisyTick& situation : situations()) {
        SCOPED_TRACE(situation.name);
        const Cantilever lever = leverAt(situation);
        const DecouplingInput input = inputAt(situation);
        const Matrix3 covariance = estimateForce(lever, input).covariance;
        const Scatter scatter = scatterOfErrors(lever, ImperfectWorld(lever, input), covariance);
        for (int i = 0; i < 3; ++i) {
            const double meanError = std::sqrt(covariance(i, i) / kNoiseDraws);
            EXPECT_NEAR(scatter.mean(i), 0.0, kStandardErrors * meanError) << i;
            for (int j = 0; j <= i; ++j) {
                const double error = std::sqrt(
                    (covariance(i, i) * covariance(j, j) + covariance(i, j) * covariance(i, j)) /
                    kNoiseDraws);
                EXPECT_NEAR(scatter.products(i, j), covariance(i, j), kStandardErrors * error)
                    << i << j;
            }
        }
        // Three degrees of freedom: mean 3, variance 6.
        EXPECT_NEAR(scatter.chiSquare, 3.0, kStandardErrors * std::sqrt(6.0 / kNoiseDraws));
    }
}

/// Flags beyond three sigma are for what is wrong, not for noise: in a world as imperfect as the
/// estimator takes it to be they stay rare.
TEST(DecouplingNoise, HardlyEverRaisesAFlag) {
    NoisyTick situation;
    situation.velocity = heading(60.0);
    const Cantilever lever = leverAt(situation);
    const ImperfectWorld world(lever, inputAt(situation));
    Random random(12);
    int flagged = 0;
    for (int i = 0; i < kNoiseDraws; ++i) {
        DecouplingInput input;
        (void)world.draw(random, input);
        flagged += estimateForce(lever, input).plausibility.holds() ? 0 : 1;
    }
    // Three tests beyond 3 sigma of noise: at most 0.8 % of the draws.
    EXPECT_LT(flagged, 120);
    EXPECT_GT(flagged, 0) << "noise of 10,000 draws goes beyond 3 sigma now and then";
}

/// A normal that is off by its deviation, in a world that is otherwise as imperfect as stated: the
/// force belongs to the true normal, the estimate to the assumed one.
double chiSquareOfTurnedNormals(const NoisyTick& situation, double turned, double stated) {
    constexpr int kDraws = 4000;
    const Cantilever lever = leverAt(situation);
    Random random(13);
    double sum = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const Vector3 first = situation.normal.unitOrthogonal();
        const Vector3 second = situation.normal.cross(first);
        NoisyTick truth = situation;
        truth.normal = (situation.normal + turned * random.normal() * first +
                        turned * random.normal() * second)
                           .normalized();
        const ImperfectWorld world(lever, inputAt(truth));
        DecouplingInput input;
        const Vector3 force = world.draw(random, input);
        input.normal = situation.normal;
        input.normalDeviation = stated;
        const ForceEstimate estimate = estimateForce(lever, input);
        const Vector3 error = estimate.force - force;
        sum += error.dot(estimate.covariance.llt().solve(error)) / kDraws;
    }
    return sum / 3.0;
}

/// Positions where the tip slides, one of them by a steep approach to a slope.
std::vector<NoisyTick> slidingSituations() {
    std::vector<NoisyTick> sliding{{.name = "steep approach",
                                    .normal = Vector3(0.3, -0.2, 1.0).normalized(),
                                    .velocity = -1e-6 * Vector3::UnitZ()}};
    for (const NoisyTick& situation : situations()) {
        if (situation.velocity.cross(situation.normal).norm() > 1e-7) {
            sliding.push_back(situation);
        }
    }
    return sliding;
}

TEST(DecouplingNoise, CountsTheNormalsDeviation) {
    constexpr double kDegree = pi / 180.0;
    ASSERT_GE(slidingSituations().size(), 12U);
    double worstWithout = 0.0;
    for (const NoisyTick& situation : slidingSituations()) {
        for (const double deviation : {0.3 * kDegree, 1.0 * kDegree, 3.0 * kDegree}) {
            SCOPED_TRACE(situation.name + ", " + std::to_string(deviation));
            const double stated = chiSquareOfTurnedNormals(situation, deviation, deviation);
            // 4,000 draws scatter by 0.013: five of these, and a turn's second order.
            EXPECT_NEAR(stated, 1.0, 0.1);
            worstWithout =
                std::max(worstWithout, chiSquareOfTurnedNormals(situation, deviation, 0.0));
        }
    }
    EXPECT_GT(worstWithout, 10.0) << "the normal taken for exact";
    std::printf("normal 3 degrees off, taken for exact: chi^2 / 3 up to %.1f\n", worstWithout);
}

TEST(DecouplingNoise, WithAnExactNormalIsAsBeforeToTheBit) {
    for (const NoisyTick& situation : situations()) {
        DecouplingInput input = inputAt(situation);
        const ForceEstimate before = estimateForce(leverAt(situation), input);
        input.normalDeviation = 1e-300;  // goes through every term, and adds nothing
        const ForceEstimate after = estimateForce(leverAt(situation), input);
        EXPECT_EQ(before.force, after.force) << situation.name;
        EXPECT_EQ(before.covariance, after.covariance) << situation.name;
    }
}

TEST(DecouplingNoise, RefusesANormalWithoutDirection) {
    const NoisyTick situation = situations().front();
    for (const double deviation : {-1e-3, 1.5, std::nan("")}) {
        DecouplingInput input = inputAt(situation);
        input.normalDeviation = deviation;
        EXPECT_EQ(estimateForce(leverAt(situation), input).kind, DecouplingCase::InvalidInput);
    }
}

}  // namespace
}  // namespace asperity
