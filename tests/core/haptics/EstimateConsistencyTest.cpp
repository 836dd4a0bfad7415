#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity {
namespace {

constexpr double kSlideFrom = 3.5;   // of slidePath() over 10 s [s]
constexpr double kSlideTo = 6.5005;  // [s]

/// How true the covariance of the estimate is while the tip slides, per degree of freedom.
struct Honesty {
    double before = 0.0;  ///< chi-square up to the flag; of all where it does not come
    double after = 0.0;   ///< and from then on
    long ticksBefore = 0;
    long ticksAfter = 0;
    std::optional<double> delay;  ///< of the flag, from the start of the slide [s]
    long elsewhere = 0;           ///< flagged ticks outside the slide
};

double chiSquare(const ForceEstimate& estimate, const Vector3& truth) {
    const Vector3 error = estimate.force - truth;
    return error.dot(estimate.covariance.ldlt().solve(error)) / 3.0;
}

/// The run of `asperity explore`, at a light load: 3 seeds, friction in truth as given.
Honesty honestyOf(const Friction& friction) {
    SceneDescription description = test::plainScene();
    description.truth.material.friction = friction;
    Scene scene = buildScene(description, test::flatMap());
    const DevicePath path = slidePath(scene, {.duration = 10.0, .indentation = 1.0_nm});
    Honesty honesty;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        InstrumentTruth truth = truthOf(scene);
        truth.seed = seed;
        SimulatedAfm afm(scene.surface, truth);
        bool flagged = false;
        runVirtually(scene, path, afm, 10001, [&](const TickSample& sample) {
            const TickOutput& out = sample.output;
            const bool now = out.flags.has(Validity::EstimateInconsistent);
            if (sample.time <= kSlideFrom || sample.time >= kSlideTo) {
                honesty.elsewhere += now ? 1 : 0;
                return;
            }
            if (now && !flagged) {
                flagged = true;
                honesty.delay = std::max(honesty.delay.value_or(0.0), sample.time - kSlideFrom);
            }
            (flagged ? honesty.after : honesty.before) +=
                chiSquare(out.estimate, afm.trueState().force);
            ++(flagged ? honesty.ticksAfter : honesty.ticksBefore);
        });
    }
    honesty.before /= static_cast<double>(std::max(1L, honesty.ticksBefore));
    honesty.after /= static_cast<double>(std::max(1L, honesty.ticksAfter));
    return honesty;
}

TEST(EstimateConsistency, SaysNothingWhereTruthIsAsBelieved) {
    const Honesty honesty = honestyOf({.coefficient = 0.3});
    EXPECT_FALSE(honesty.delay.has_value());
    EXPECT_EQ(honesty.elsewhere, 0);
    EXPECT_LT(honesty.before, 1.05);
}

/// The estimate used to be several of its standard deviations off, and no flag came.
TEST(EstimateConsistency, FlagsAWrongFrictionLawAndWidensTheCovariance) {
    for (const Friction& truth : {Friction{.coefficient = 0.3, .shearStrength = 30.0_MPa},
                                  Friction{.coefficient = 0.45, .shearStrength = 30.0_MPa},
                                  Friction{.coefficient = 0.45}, Friction{.coefficient = 0.15}}) {
        SCOPED_TRACE(::testing::Message() << truth.coefficient << " " << truth.shearStrength);
        const Honesty honesty = honestyOf(truth);
        ASSERT_TRUE(honesty.delay.has_value());
        EXPECT_LT(*honesty.delay, 0.5);
        EXPECT_EQ(honesty.elsewhere, 0);
        EXPECT_LT(honesty.after, 1.2);
        EXPECT_GT(honesty.after, 0.1) << "so wide that it would hide any error";
    }
}

/// Along the beam no signal shows friction. A belief without friction was certain of none to 0.3
/// pN.
TEST(EstimateConsistency, IsNotCertainOfALawThatNothingTests) {
    for (const double believed : {0.0, 0.1, 0.3}) {
        SceneDescription description = test::plainScene();
        description.sample.material.friction = {.coefficient = believed};
        description.truth.material.friction = {.coefficient = believed + 0.05};
        const Scene scene = buildScene(description, test::flatMap());
        SimulatedAfm afm(scene.surface, truthOf(scene));
        const DevicePath path{{0.0, {30.0_nm, 64.0_nm, 10.0_nm}},
                              {1.0, {30.0_nm, 64.0_nm, -1.0_nm}},
                              {3.0, {80.0_nm, 64.0_nm, -1.0_nm}}};
        double farthest = 0.0;  // of the error, in standard deviations
        long ticks = 0;
        runVirtually(scene, path, afm, 3001, [&](const TickSample& sample) {
            const ForceEstimate& estimate = sample.output.estimate;
            if (sample.time > 1.2) {
                const double sigma = std::sqrt(estimate.covariance(0, 0));
                farthest = std::max(
                    farthest, std::abs(estimate.force.x() - afm.trueState().force.x()) / sigma);
                ++ticks;
            }
        });
        EXPECT_GT(ticks, 1000);
        EXPECT_LT(farthest, 3.0) << believed;
    }
}

/// A thousand seconds in free air: the test of one tick flashed twice a second.
TEST(EstimateConsistency, FlashesNotOnceInFreeAir) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    SimulatedAfm afm(scene.surface, truthOf(scene));
    const DevicePath path{{0.0, {64.0_nm, 64.0_nm, 50.0_nm}}};
    long flagged = 0;
    runVirtually(scene, path, afm, 1'000'000, [&](const TickSample& sample) {
        const ValidityFlags flags = sample.output.flags;
        flagged +=
            flags.has(Validity::ModelContradicted) || flags.has(Validity::EstimateInconsistent) ? 1
                                                                                                : 0;
    });
    EXPECT_EQ(flagged, 0);
}

/// The true sample adheres less than the believed one and lets go earlier.
TEST(EstimateConsistency, ContradictsAModelThatStillAdheresAtOnce) {
    SceneDescription description = test::plainScene();
    description.truth.material.workOfAdhesion = 0.02;
    const Scene scene = buildScene(description, test::flatMap());
    SimulatedAfm afm(scene.surface, truthOf(scene));
    const DevicePath path = slidePath(scene, {.duration = 10.0, .indentation = 1.0_nm});
    std::optional<double> alone;  // since when only the model is bonded
    std::optional<double> noticed;
    runVirtually(scene, path, afm, 10001, [&](const TickSample& sample) {
        const bool modelBonded =
            sample.output.model.contact.branch == ContactBranch::Bonded && sample.time > kSlideTo;
        if (modelBonded && afm.trueState().contact.branch == ContactBranch::Far && !alone) {
            alone = sample.time;
        }
        if (alone && !noticed && sample.output.flags.has(Validity::ModelContradicted)) {
            noticed = sample.time;
        }
    });
    ASSERT_TRUE(alone && noticed);
    EXPECT_LE(*noticed - *alone, 5e-3);
}

}  // namespace
}  // namespace asperity
