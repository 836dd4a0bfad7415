#include "core/Units.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/ForceCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asperity {
namespace {

constexpr ContactPair kPulledPair{40.0_nm, 53.4_GPa, 0.2};
constexpr double kPulledCompliance = 1.0 / 14.0;  // [m/N]

struct Pulled {
    ContactModel bare;
    ContactModel model;
};

Pulled pulled(ContactLaw law, const BodyPull& pull, const Meniscus& meniscus = {}) {
    const ContactModel bare(law, kPulledPair, {.meniscus = meniscus});
    ContactModel model = bare;
    model.setBodyPull(pull);
    return {bare, model};
}

constexpr std::array kPulls{BodyPull{-5.0_nN, 0.0}, BodyPull{-5.0_nN, -1.0}, BodyPull{2.0_nN, 0.5}};

TEST(BodyPull, AddsAStraightLineToTheForceOfTheLaw) {
    const Meniscus water{.surfaceTension = 0.072, .contactAngle = 0.3, .range = 2.0_nm};
    for (const ContactLaw law : {ContactLaw::Split, ContactLaw::Jkr, ContactLaw::Hertz}) {
        for (const Meniscus& meniscus : {Meniscus{}, water}) {
            for (const BodyPull& pull : kPulls) {
                const auto [bare, model] = pulled(law, pull, meniscus);
                for (const double approach : {-30.0_nm, -2.0_nm, 0.1_nm, 2.0_nm}) {
                    const ContactState state = model.equilibrium(approach, kPulledCompliance, {});
                    const ContactState held =
                        bare.equilibrium(state.indentation, 0.0, state.memory());
                    EXPECT_NEAR(state.indentation + kPulledCompliance * state.force, approach,
                                1e-18);
                    EXPECT_NEAR(state.force, held.force + pull.at(state.indentation),
                                1e-9 * std::abs(state.force) + 1e-18);
                    EXPECT_NEAR(state.stiffness, held.stiffness + pull.slope,
                                1e-6 * std::abs(held.stiffness));
                }
            }
        }
    }
}

/// The base does as much work around the loop as both jumps dissipate, whatever the line does.
TEST(BodyPull, JumpsWhereTheWholeForceDoesAndLosesItsEnergy) {
    for (const BodyPull& pull : kPulls) {
        const ContactModel model = pulled(ContactLaw::Split, pull).model;
        const double in = model.jumpInApproach(kPulledCompliance);
        const double out = model.pullOffApproach(kPulledCompliance);
        ASSERT_LT(out, in);
        const double margin = 1e-12 * (in - out);
        const ContactState landed = model.equilibrium(in + margin, kPulledCompliance, {});
        const ContactState gone = model.equilibrium(out - margin, kPulledCompliance, kBondedMemory);
        EXPECT_EQ(landed.branch, ContactBranch::Bonded);
        EXPECT_EQ(gone.branch, ContactBranch::Far);
        EXPECT_EQ(model.equilibrium(in - 1e-4 * (in - out), kPulledCompliance, {}).branch,
                  ContactBranch::Far);
        constexpr int kCells = 4000;
        double loop = 0.0;
        for (int i = 0; i < kCells; ++i) {
            const double u = (i + 0.5) / kCells;
            const double approach = out + (in - out) * u * u * (3.0 - 2.0 * u);
            const double width = (in - out) * 6.0 * u * (1.0 - u) / kCells;
            loop += width * (model.equilibrium(approach, kPulledCompliance, {}).force -
                             model.equilibrium(approach, kPulledCompliance, kBondedMemory).force);
        }
        EXPECT_NEAR(loop, landed.energyLost + gone.energyLost, 1e-5 * loop);
        EXPECT_NEAR(model.lastBonded(kPulledCompliance).indentation +
                        kPulledCompliance * model.lastBonded(kPulledCompliance).force,
                    out, 1e-9 * std::abs(out));
        EXPECT_NEAR(model.lastFar(kPulledCompliance).indentation +
                        kPulledCompliance * model.lastFar(kPulledCompliance).force,
                    in, 1e-9 * std::abs(in));
    }
}

/// On the softest lever the tip pulls off where it pulls hardest, attracted beside or not.
TEST(BodyPull, ThePullIsStrongestWhereTheSumIs) {
    for (const BodyPull& pull : kPulls) {
        const ContactModel model = pulled(ContactLaw::Split, pull).model;
        double strongest = 0.0;
        for (double indentation = -1.0_nm; indentation < 1.0_nm; indentation += 0.5_pm) {
            const ContactState state = model.equilibrium(indentation, 0.0, kBondedMemory);
            if (state.branch == ContactBranch::Bonded) {
                strongest = std::min(strongest, state.force);
            }
        }
        const std::optional<ForceCurvePoint> found = strongestPullOf(model, kPulledCompliance);
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->state.force, strongest, 1e-3 * std::abs(strongest));
    }
}

TEST(BodyPull, IsGoneFromAModelThatIsMadeFromAnother) {
    const ContactModel model = pulled(ContactLaw::Split, {-5.0_nN, -1.0}).model;
    EXPECT_FALSE(model.withTipRadius(20.0_nm).bodyPull().present());
    EXPECT_TRUE(ContactModel(model).bodyPull().present());
}

}  // namespace
}  // namespace asperity
