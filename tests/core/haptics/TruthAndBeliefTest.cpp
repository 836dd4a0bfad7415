#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// The two lever signals of a force: Fy and Fz + kappa Fx (docs/theory.md 5.2).
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
    double lateral = 0.0;          ///< mean square over all ticks
    double bending = 0.0;          ///< mean square over all ticks
    double touchingLateral = 0.0;  ///< mean square over the ticks in contact
    double touchingBending = 0.0;  ///< mean square over the ticks in contact
    double slidingLateral = 0.0;   ///< mean square over the ticks in which the tip slides
    double within3Sigma = 0.0;     ///< share of all ticks with both deviations inside
};

/// How far the true sample is from the believed one, as factors.
struct Mismatch {
    double stiffness = 1.0;
    double adhesion = 1.0;
    double friction = 1.0;
};

/// A run of 10,000 ticks over soft hills, in and out of contact, on a sample that is not what the
/// operator's side believes.
class TruthAndBelief : public ::testing::TestWithParam<Mismatch> {
protected:
    struct Tick {
        TickOutput output;
        Vector3 trueForce;
        bool touching;
    };

    void SetUp() override {
        SceneDescription description = test::plainScene();
        description.truth.material.elastic.youngsModulus *= GetParam().stiffness;
        description.truth.material.workOfAdhesion *= GetParam().adhesion;
        description.truth.material.friction.coefficient *= GetParam().friction;
        const Scene scene = buildScene(description, test::hillyMap());
        kappa = scene.belief.cantilever.couplingRatio();
        SimulatedAfm afm(scene.surface, truthOf(scene));
        const DevicePath path = slidePath(scene, {.duration = 10.0, .slideLength = 60.0_nm});
        runVirtually(scene, path, afm, 10000, [&](const TickSample& sample) {
            const TipState& truth = afm.trueState();
            ticks.push_back({sample.output, truth.force, truth.contact.contactRadius > 0.0});
        });
    }

    /// @param force which force of a tick to hold against the truth
    template <class Force>
    [[nodiscard]] Consistency consistencyOf(const Force& force) const {
        Consistency result;
        const auto count = static_cast<double>(ticks.size());
        double touching = 0.0;
        double sliding = 0.0;
        for (const Tick& tick : ticks) {
            const SensedForce truth = sensed(tick.trueForce, kappa);
            const SensedForce found = sensed(force(tick), kappa);
            const SensedForce sigma = sensedSigma(tick.output.estimate.covariance, kappa);
            const double lateral = (found.lateral - truth.lateral) / sigma.lateral;
            const double bending = (found.bending - truth.bending) / sigma.bending;
            result.lateral += lateral * lateral / count;
            result.bending += bending * bending / count;
            if (tick.touching) {
                result.touchingLateral += lateral * lateral;
                result.touchingBending += bending * bending;
                touching += 1.0;
            }
            if (tick.touching && tick.output.model.slip.norm() > 0.5) {
                result.slidingLateral += lateral * lateral;
                sliding += 1.0;
            }
            if (std::abs(lateral) < 3.0 && std::abs(bending) < 3.0) {
                result.within3Sigma += 1.0 / count;
            }
        }
        result.touchingLateral /= touching;
        result.touchingBending /= touching;
        result.slidingLateral /= sliding;
        return result;
    }

    std::vector<Tick> ticks;
    double kappa = 0.0;
};

TEST_P(TruthAndBelief, EstimateAgreesWithTruthWithinItsCovariance) {
    const Consistency estimate =
        consistencyOf([](const Tick& tick) { return tick.output.estimate.force; });
    EXPECT_LT(estimate.lateral, 1.5);
    EXPECT_LT(estimate.bending, 1.5);
    EXPECT_GT(estimate.within3Sigma, 0.99);
    // While the tip slides 1 is a perfectly stated covariance; one far too wide would hide any
    // error. Friction off by 50 % is 1.7 of the 30 % that the estimator allows its friction law: it
    // used to make this 1.1 to 1.6. At rest the law is exact, and the estimate better than stated.
    EXPECT_NEAR(estimate.slidingLateral, 1.0, 0.15);
    EXPECT_LT(estimate.touchingLateral, 1.1);
    EXPECT_NEAR(estimate.touchingBending, 1.0, 0.05);
}

TEST_P(TruthAndBelief, ModelForceInItsPlaceFails) {
    const Consistency model =
        consistencyOf([](const Tick& tick) { return tick.output.model.force; });
    EXPECT_GT(model.bending, 10.0);
    EXPECT_LT(model.within3Sigma, 0.9);
}

INSTANTIATE_TEST_SUITE_P(OffByThirtyAndFiftyPercent, TruthAndBelief,
                         ::testing::Values(Mismatch{1.3, 1.3, 1.5}, Mismatch{1.3, 1.3, 0.5},
                                           Mismatch{1.3, 0.7, 1.5}, Mismatch{1.3, 0.7, 0.5},
                                           Mismatch{0.7, 1.3, 1.5}, Mismatch{0.7, 1.3, 0.5},
                                           Mismatch{0.7, 0.7, 1.5}, Mismatch{0.7, 0.7, 0.5}));

}  // namespace
}  // namespace asperity
