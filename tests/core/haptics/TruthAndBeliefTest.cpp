#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/probe/SimulatedAfm.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

/// What the two lever signals tell of a force: Fy and Fz + kappa Fx (docs/physics.md 5.2).
struct SensedForce {
    double lateral = 0.0;  ///< Fy [N]
    double bending = 0.0;  ///< Fz + kappa Fx [N]
};

SensedForce sensed(const Vector3& force, double kappa) {
    return {force.y(), force.z() + kappa * force.x()};
}

SensedForce sensedSigma(const Matrix3& covariance, double kappa) {
    const Vector3 bending(kappa, 0.0, 1.0);
    return {std::sqrt(covariance(1, 1)), std::sqrt(bending.dot(covariance * bending))};
}

/// Deviations from truth in units of the estimate's own standard deviation.
struct Consistency {
    double meanSquareLateral = 0.0;
    double meanSquareBending = 0.0;
    double within3Sigma = 0.0;  ///< share of ticks with both deviations inside
};

/// A run of 10,000 ticks over soft hills, in and out of contact, with a sample that is 30 % stiffer
/// and more adhesive and half as slippery again as believed.
class TruthAndBelief : public ::testing::Test {
protected:
    struct Tick {
        TickOutput output;
        Vector3 trueForce;
    };

    static void SetUpTestSuite() {
        SceneDescription description = test::plainScene();
        description.truth.material.elastic.youngsModulus *= 1.3;
        description.truth.material.workOfAdhesion *= 1.3;
        description.truth.material.friction.coefficient *= 1.5;
        const Scene scene = buildScene(description, test::hillyMap());
        kappa_ = scene.belief.cantilever.couplingRatio();
        SimulatedAfm afm(scene.surface, scene.truth);
        const HandPath path = approachPath(scene, {.duration = 10.0});
        runVirtually(scene, path, afm, 10000, [&](const TickSample& sample) {
            ticks_.push_back({sample.output, afm.trueState().force});
        });
    }

    /// @param force which force of a tick to hold against the truth
    template <class Force>
    static Consistency consistencyOf(const Force& force) {
        Consistency result;
        const auto count = static_cast<double>(ticks_.size());
        for (const Tick& tick : ticks_) {
            const SensedForce truth = sensed(tick.trueForce, kappa_);
            const SensedForce found = sensed(force(tick), kappa_);
            const SensedForce sigma = sensedSigma(tick.output.estimate.covariance, kappa_);
            const double lateral = (found.lateral - truth.lateral) / sigma.lateral;
            const double bending = (found.bending - truth.bending) / sigma.bending;
            result.meanSquareLateral += lateral * lateral / count;
            result.meanSquareBending += bending * bending / count;
            if (std::abs(lateral) < 3.0 && std::abs(bending) < 3.0) {
                result.within3Sigma += 1.0 / count;
            }
        }
        return result;
    }

    static inline std::vector<Tick> ticks_;
    static inline double kappa_ = 0.0;
};

TEST_F(TruthAndBelief, EstimateAgreesWithTruthWithinItsCovariance) {
    const Consistency estimate =
        consistencyOf([](const Tick& tick) { return tick.output.estimate.force; });
    EXPECT_LT(estimate.meanSquareLateral, 1.5);
    EXPECT_LT(estimate.meanSquareBending, 1.5);
    EXPECT_GT(estimate.within3Sigma, 0.99);
    RecordProperty("mean_square_lateral", std::to_string(estimate.meanSquareLateral));
    RecordProperty("mean_square_bending", std::to_string(estimate.meanSquareBending));
    RecordProperty("within_3_sigma", std::to_string(estimate.within3Sigma));
}

TEST_F(TruthAndBelief, ModelForceInItsPlaceWouldFailTheSameTest) {
    const Consistency model =
        consistencyOf([](const Tick& tick) { return tick.output.model.force; });
    EXPECT_GT(model.meanSquareBending, 10.0);
    EXPECT_LT(model.within3Sigma, 0.9);
}

}  // namespace
}  // namespace asperity
