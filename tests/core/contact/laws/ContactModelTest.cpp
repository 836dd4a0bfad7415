#include "core/contact/laws/ContactModel.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/SplitLaw.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace asperity {
namespace {

using test::expectClose;
using test::kInfinity;
using test::kNan;
using test::paperPair;
using test::ReferenceTable;

ContactModel splitModel(const std::string& material) {
    return {ContactLaw::Split, paperPair(material)};
}

TEST(SplitLaw, DividesAdhesionLikeTheReference) {
    const ReferenceTable table = test::referenceTable("T07c_split_critical.csv");
    ASSERT_EQ(table.rows(), 3U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "material"));
        const ContactModel model = splitModel(table.text(row, "material"));
        ASSERT_NE(model.split(), nullptr);
        const AdhesionSplit& split = *model.split();
        expectClose(split.hamaker, table.number(row, "H_J"), 1e-13);
        expectClose(split.jointSeparation, table.number(row, "Ds_m"), 1e-14);
        expectClose(split.cohesiveWork, table.number(row, "wD"), 1e-14);
        expectClose(split.cohesiveStress, table.number(row, "s0_Pa"), 1e-13);
        expectClose(model.lambda(), table.number(row, "lambda_D"), 1e-13);
        expectClose(split.tailForce, table.number(row, "Fs_N"), 1e-13);
        expectClose(split.tailLift, table.number(row, "us_m"), 1e-13);
        expectClose(model.tail()->elasticInstability(), table.number(row, "Dstar_m"), 1e-13);
        EXPECT_EQ(split.tailSnaps, table.number(row, "tail_fold") == 1.0);
    }
}

TEST(SplitLaw, BreaksUnderDisplacementControlLikeTheReference) {
    const ReferenceTable table = test::referenceTable("T07c_split_critical.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "material"));
        const ContactModel model = splitModel(table.text(row, "material"));
        // The column holds the fold of the tail; a stiff tail ends at the joint before it.
        const double jumpIn = model.split()->tailSnaps
                                  ? table.number(row, "snap_delta_m")
                                  : -(table.number(row, "hs_m") + table.number(row, "us_m"));
        expectClose(model.jumpInApproach(0.0), jumpIn, 1e-12);
        const double jumpOff = table.number(row, "do_delta_m");
        expectClose(model.pullOffApproach(0.0), jumpOff, 1e-12);
        const ContactState last =
            model.equilibrium(jumpOff * (1.0 - 1e-13), 0.0, {ContactBranch::Bonded});
        EXPECT_EQ(last.branch, ContactBranch::Bonded);
        expectClose(last.force, table.number(row, "do_P_N"), 1e-5);
        const ContactState gone =
            model.equilibrium(jumpOff * (1.0 + 1e-13), 0.0, {ContactBranch::Bonded});
        EXPECT_EQ(gone.branch, ContactBranch::Far);
        EXPECT_TRUE(gone.jumped);
    }
}

TEST(SplitLaw, FollowsTheReferenceCurve) {
    const ReferenceTable table = test::referenceTable("T07_split_curve.csv");
    ASSERT_EQ(table.rows(), 134U);
    int stable = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.number(row, "stable_disp") == 0.0) {
            continue;
        }
        SCOPED_TRACE(row);
        const ContactModel model = splitModel(table.text(row, "material"));
        const bool tail = table.text(row, "region") == "tail";
        const ContactBranch branch = tail ? ContactBranch::Far : ContactBranch::Bonded;
        const double indentation = table.number(row, "delta_m");
        // The last row of a stiff tail is the joint itself: rounding may put it beyond.
        const bool joint = tail && std::abs(indentation - model.jumpInApproach(0.0)) < 1e-18;
        const ContactState state =
            model.equilibrium(joint ? indentation - 1e-22 : indentation, 0.0, {branch});
        EXPECT_EQ(state.branch, branch);
        EXPECT_FALSE(state.jumped);
        expectClose(state.indentation, indentation, 1e-11);
        expectClose(state.force, table.number(row, "P_N"), 1e-11, tail ? 0.0 : 1e-9);
        expectClose(state.contactRadius, table.number(row, "a_m"), 1e-11);
        if (!tail) {
            expectClose(state.cohesiveRadius, table.number(row, "c_m"), 1e-11);
        }
        ++stable;
    }
    EXPECT_EQ(stable, 114);
}

/// Snap-in, landing, pull-off and what follows it, on levers of 0.5, 14 and 200 N/m.
TEST(SplitLaw, JumpsOnALeverLikeTheReference) {
    const ReferenceTable table = test::referenceTable("T21_split_spring_critical.csv");
    ASSERT_EQ(table.rows(), 9U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model = splitModel(table.text(row, "material"));
        const double compliance = 1.0 / table.number(row, "k");
        const double jumpIn = model.jumpInApproach(compliance);
        expectClose(jumpIn, table.number(row, "in_xb_m"), 1e-12);
        const double after = jumpIn + (1e-14 * std::abs(jumpIn));
        const ContactState landed = model.equilibrium(after, compliance, {ContactBranch::Far});
        EXPECT_TRUE(landed.jumped);
        EXPECT_GT(landed.energyLost, 0.0);
        EXPECT_EQ(landed.branch, ContactBranch::Bonded);
        expectClose(landed.force, table.number(row, "land_P_N"), 1e-9);
        expectClose(landed.indentation, table.number(row, "land_delta_m"), 1e-9);
        expectClose(landed.contactRadius, table.number(row, "land_a_m"), 1e-9);
        expectClose(landed.cohesiveRadius, table.number(row, "land_c_m"), 1e-9);

        const double pullOff = model.pullOffApproach(compliance);
        expectClose(pullOff, table.number(row, "off_xb_m"), 1e-12);
        const double beyond = pullOff - (1e-14 * std::abs(pullOff));
        const ContactState gone = model.equilibrium(beyond, compliance, {ContactBranch::Bonded});
        EXPECT_TRUE(gone.jumped);
        EXPECT_GT(gone.energyLost, 0.0);
        EXPECT_EQ(gone.branch, ContactBranch::Far);
        expectClose(gone.force, table.number(row, "after_P_N"), 1e-9);
    }
}

TEST(SplitLaw, HoldsToTheLastBeforeItSnapsInOrPullsOff) {
    const ReferenceTable table = test::referenceTable("T21_split_spring_critical.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel model = splitModel(table.text(row, "material"));
        const double compliance = 1.0 / table.number(row, "k");
        const double jumpIn = model.jumpInApproach(compliance);
        const ContactState before = model.equilibrium(jumpIn - (1e-13 * std::abs(jumpIn)),
                                                      compliance, {ContactBranch::Far});
        EXPECT_EQ(before.branch, ContactBranch::Far);
        expectClose(before.force, table.number(row, "in_P_N"), 1e-5);
        const double pullOff = model.pullOffApproach(compliance);
        const ContactState last = model.equilibrium(pullOff + (1e-13 * std::abs(pullOff)),
                                                    compliance, {ContactBranch::Bonded});
        EXPECT_EQ(last.branch, ContactBranch::Bonded);
        expectClose(last.force, table.number(row, "off_P_N"), 1e-5);
        expectClose(last.contactRadius, table.number(row, "off_a_m"), 1e-5);
        EXPECT_EQ(last.contactRadius > 0.0, table.text(row, "off_kind") == "contact");
    }
}

/// A soft tail ends before the joint; the bond then has all of the adhesion and is JKR's.
TEST(SplitLaw, BecomesJkrForSoftLargeTips) {
    const ContactPair pair{10_um, 1333.0, 10.0};
    const ContactModel model(ContactLaw::Split, pair);
    EXPECT_TRUE(model.split()->tailSnaps);
    const double units = std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
    const ContactState last =
        model.equilibrium(model.pullOffApproach(1e6) * (1.0 - 1e-14), 1e6, {ContactBranch::Bonded});
    expectClose(last.force, -1.5 * units, 1e-6);
}

constexpr std::array kPaperMaterials{"SiO2", "PS", "rubber"};

/// Before contact nothing knows the shape of the tip beyond its radius.
TEST(SphereSplitLaw, SnapsInWhereTheSplitLawDoes) {
    for (const char* material : kPaperMaterials) {
        const ContactModel split(ContactLaw::Split, paperPair(material));
        const ContactModel sphere(ContactLaw::SphereSplit, paperPair(material));
        for (const double stiffness : {0.5, 14.0, 200.0, kInfinity}) {
            SCOPED_TRACE(std::string(material) + " on " + std::to_string(stiffness) + " N/m");
            const double compliance = 1.0 / stiffness;
            const double jumpIn = sphere.jumpInApproach(compliance);
            EXPECT_EQ(jumpIn, split.jumpInApproach(compliance));
            EXPECT_EQ(sphere.lastFar(compliance).force, split.lastFar(compliance).force);
            const double after = jumpIn + (1e-14 * std::abs(jumpIn));
            const ContactState landed = sphere.equilibrium(after, compliance, {});
            const ContactState other = split.equilibrium(after, compliance, {});
            EXPECT_TRUE(landed.jumped);
            EXPECT_GT(landed.energyLost, 0.0);
            EXPECT_EQ(landed.branch, ContactBranch::Bonded);
            EXPECT_GE(landed.force, other.force * (1.0 + 0.02)) << "no larger jump";
        }
    }
}

/// What was lost: at 2 nm over rubber the tip is in contact, and 14 N/m snap in at -2.84 nm.
TEST(SphereSplitLaw, RubberIsInContactAtTwoNanometers) {
    const ContactPair rubber = paperPair("rubber");
    const ContactModel model(chooseLaw({}, rubber).law, rubber);
    const ContactState state = model.equilibrium(-2e-9, 0.0, {});
    EXPECT_EQ(state.region(), TipRegion::Contact);
    EXPECT_LT(state.force, -0.3e-9);
    EXPECT_NEAR(model.jumpInApproach(1.0 / 14.0), -2.84e-9, 0.005e-9);
}

/// The zone begins where the tail ends, and has all of the adhesion where that is unstable.
TEST(SphereSplitLaw, IsContinuousAtTheJointOrHasTheWholeZone) {
    for (const char* material : kPaperMaterials) {
        SCOPED_TRACE(material);
        const ContactPair pair = paperPair(material);
        const ContactModel model(ContactLaw::SphereSplit, pair);
        const AdhesionSplit& split = *model.split();
        const AttractiveTail& tail = *model.tail();
        const SphereMaugisLaw zone({pair.tipRadius, pair.reducedModulus, split.cohesiveWork},
                                   split.cohesiveStress);
        EXPECT_EQ(split.tailSnaps, std::string(material) == "rubber");
        const LawPoint first = zone.apart(0.0);
        EXPECT_EQ(first.force, 0.0);
        if (!split.tailSnaps) {
            const double joint = split.jointSeparation;
            expectClose(first.force + split.tailForce, tail.attraction().force(joint), 1e-14);
            expectClose(first.indentation - split.tailLift, tail.indentation(joint), 1e-14);
            EXPECT_EQ(split.tailEnergy, tail.energy(joint));
        } else {
            const ContactModel whole(ContactLaw::SphereMaugis, pair);
            for (const double indentation : {-5e-9, 0.0, 5e-9}) {
                const ContactState one =
                    model.equilibrium(indentation, 0.0, {ContactBranch::Bonded});
                expectClose(one.force,
                            whole.equilibrium(indentation, 0.0, {ContactBranch::Bonded}).force,
                            1e-9);
            }
        }
    }
}

TEST(Hertz, HasTheReferenceForceWithoutAdhesion) {
    const ReferenceTable table = test::referenceTable("T12_extremes.csv");
    int compared = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.number(row, "w") != 0.0) {
            continue;
        }
        SCOPED_TRACE(row);
        const ContactPair pair{table.number(row, "R_m"), table.number(row, "Es_Pa"), 0.0};
        const double indentation = table.number(row, "delta_m");
        for (const ContactLaw law : {ContactLaw::Hertz, ContactLaw::Split}) {
            const ContactModel model(law, pair);
            EXPECT_EQ(model.split(), nullptr);
            const ContactState state = model.equilibrium(indentation, 0.0, {ContactBranch::Far});
            expectClose(state.force, table.number(row, "P_N"), 1e-14);
            expectClose(state.contactRadius, table.number(row, "a_m"), 1e-14);
            expectClose(state.cohesiveRadius, table.number(row, "c_m"), 1e-14);
            EXPECT_EQ(state.branch, indentation > 0.0 ? ContactBranch::Bonded : ContactBranch::Far);
        }
        ++compared;
    }
    EXPECT_GT(compared, 100);
}

TEST(Hertz, BalancesALever) {
    test::checkProperty([] {
        ContactPair pair = *test::adhesivePair();
        const double compliance = *test::anyCompliance();
        const ContactModel model(ContactLaw::Hertz, pair);
        const double approach = pair.tipRadius * *test::logUniform(1e-9, 1.0);
        const ContactState state = model.equilibrium(approach, compliance, {ContactBranch::Far});
        RC_ASSERT(state.force > 0.0);
        RC_ASSERT(std::abs(state.indentation + (compliance * state.force) - approach) <=
                  1e-14 * approach);
        RC_ASSERT(model.equilibrium(-approach, compliance, {ContactBranch::Bonded}).force == 0.0);
    });
}

/// Where the cohesive zone ends, the surfaces are as far apart as the cohesion reaches.
TEST(ContactModel, OpensByTheCohesiveRangeAtTheEndOfItsZone) {
    for (const char* material : {"SiO2", "PS", "rubber"}) {
        const ContactPair pair = paperPair(material);
        const double stress = pair.workOfAdhesion / 0.5e-9;
        for (const ContactLaw law : {ContactLaw::Maugis, ContactLaw::SphereMaugis}) {
            const ContactModel model(law, pair, {.cohesiveStress = stress});
            EXPECT_EQ(model.cohesiveStress(), stress);
            const ContactState state = model.equilibrium(0.0, 0.0, {ContactBranch::Bonded});
            const double c = state.cohesiveRadius;
            const double shape = isSphere(law)
                                     ? c * c / (15_nm + std::sqrt((15_nm - c) * (15_nm + c)))
                                     : c * c / (2.0 * 15_nm);
            const double gap = shape - state.indentation + surfaceDisplacement(model, state, c);
            expectClose(gap, 0.5e-9, 1e-8);
        }
    }
}

TEST(ContactModel, DoesNotSolveWhatIsNotFinite) {
    for (const ContactLaw law : {ContactLaw::Hertz, ContactLaw::Split}) {
        const ContactModel model(law, paperPair("PS"));
        const std::array<std::array<double, 2>, 7> inputs{{{kNan, 0.1},
                                                           {kInfinity, 0.1},
                                                           {-kInfinity, 0.1},
                                                           {2e3, 0.1},
                                                           {0.0, kNan},
                                                           {0.0, kInfinity},
                                                           {0.0, -0.1}}};
        for (const auto& [approach, compliance] : inputs) {
            const ContactState state =
                model.equilibrium(approach, compliance, {ContactBranch::Bonded});
            EXPECT_FALSE(state.solved());
            EXPECT_EQ(state.force, 0.0);
            EXPECT_EQ(state.branch, ContactBranch::Bonded);
        }
    }
}

TEST(ContactModel, RefusesParametersOutsideTheirRange) {
    for (const double bad : {kNan, kInfinity, -kInfinity, -1.0}) {
        EXPECT_THROW(ContactModel(ContactLaw::Split, {bad, 1e9, 0.1}), Error);
        EXPECT_THROW(ContactModel(ContactLaw::Split, {15_nm, bad, 0.1}), Error);
        EXPECT_THROW(ContactModel(ContactLaw::Hertz, {15_nm, 1e9, bad}), Error);
    }
    EXPECT_THROW(ContactModel(ContactLaw::Split, {0.0, 1e9, 0.1}), Error);
    EXPECT_THROW(ContactModel(ContactLaw::Split, {15_nm, 0.0, 0.1}), Error);
}

/// Bodies that only push each other meet and part without a jump, with no energy lost.
TEST(ContactModel, MeetsAndPartsWithoutAJumpWhereNothingAttracts) {
    for (const ContactLaw law : {ContactLaw::Hertz, ContactLaw::Sneddon}) {
        const ContactModel model(law, {15.0_nm, 1.0_GPa, 0.0});
        const ContactState touching = model.equilibrium(1.0_nm, 0.1, {ContactBranch::Far});
        EXPECT_EQ(touching.branch, ContactBranch::Bonded);
        EXPECT_FALSE(touching.jumped);
        const ContactState apart = model.equilibrium(-1.0_nm, 0.1, {ContactBranch::Bonded});
        EXPECT_EQ(apart.branch, ContactBranch::Far);
        EXPECT_FALSE(apart.jumped);
        EXPECT_EQ(touching.energyLost + apart.energyLost, 0.0);
    }
}

/// The law of a position is that of a uniform sample of its material.
TEST(ContactModel, WithAnotherPairIsTheModelOfThatPair) {
    const ContactPair usual{.tipRadius = 15e-9, .reducedModulus = 3e9, .workOfAdhesion = 0.06};
    const ContactPair other{.tipRadius = 22e-9, .reducedModulus = 0.4e9, .workOfAdhesion = 0.015};
    const auto optionsOf = [](const ContactPair& pair) {
        return ContactOptions{.cohesiveStress = pair.workOfAdhesion / 0.5e-9,
                              .filmThickness = 100e-9};
    };
    for (const ContactLaw law : kValues<ContactLaw>) {
        SCOPED_TRACE(keyOf(law));
        const ContactModel made = ContactModel(law, usual, optionsOf(usual)).withPair(other);
        const ContactModel expected(law, other, optionsOf(other));
        EXPECT_NEAR(made.cohesiveStress(), expected.cohesiveStress(),
                    1e-12 * expected.cohesiveStress());
        for (const double approach : {-3e-9, 0.1e-9, 2e-9}) {
            const ContactMemory bonded{ContactBranch::Bonded, 0.0};
            const ContactState state = made.equilibrium(approach, 0.05, bonded);
            const ContactState wanted = expected.equilibrium(approach, 0.05, bonded);
            EXPECT_NEAR(state.force, wanted.force, 1e-9 * std::abs(wanted.force)) << approach;
        }
    }
    const ContactModel dry = ContactModel(ContactLaw::Maugis, usual).withPair({15e-9, 3e9, 0.0});
    EXPECT_EQ(dry.lastBonded(0.0).force, 0.0) << "no adhesion where the material has none";
}

}  // namespace
}  // namespace asperity
