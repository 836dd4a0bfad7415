#include "core/contact/laws/ContactModel.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::isFinite;

/// From a tip radius before pull-off to a tip radius beyond snap-in, dense around the folds.
double approachWithinARadius(const ContactModel& model, double compliance) {
    const double pullOff = model.pullOffApproach(compliance);
    const double jumpIn = model.jumpInApproach(compliance);
    const double radius = model.pair().tipRadius;
    const double where = *test::fraction();
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return pullOff + (where * (jumpIn - pullOff));
    case 1:
        return pullOff * (1.0 + (where - 0.5) * 1e-6);
    case 2:
        return pullOff - (where * radius);
    default:
        return jumpIn + (where * radius);
    }
}

/// Forces up to here cancel in an equilibrium [N].
double forceScale(const ContactModel& model, const ContactState& state) {
    return std::abs(state.force) +
           (2.0 * std::numbers::pi * model.pair().workOfAdhesion * model.pair().tipRadius);
}

TEST(ContactModelProperty, IsFiniteAndInEquilibriumForAnyMaterialAndLever) {
    test::checkProperty([] {
        ContactPair pair = *test::adhesivePair();
        if (*rc::gen::inRange(0, 10) == 0) {
            pair.workOfAdhesion = 0.0;
        }
        const ContactModel model(ContactLaw::Split, pair);
        const double compliance = *test::anyCompliance();
        const double approach = approachWithinARadius(model, compliance);
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            const ContactState state = model.equilibrium(approach, compliance, {branch});
            RC_ASSERT(state.solved());
            RC_ASSERT(isFinite(state));
            RC_ASSERT(state.energyLost >= 0.0);
            RC_ASSERT(state.cohesiveRadius >= state.contactRadius);
            RC_ASSERT(state.contactRadius >= 0.0);
            const double off = state.indentation + (compliance * state.force) - approach;
            const double size = std::abs(approach) + 1e-9 +
                                (compliance * forceScale(model, state)) +
                                std::abs(state.indentation);
            RC_ASSERT(std::abs(off) <= 1e-11 * size);
        }
    });
}

TEST(ContactModelProperty, KeepsItsBranchWhileThatIsStable) {
    test::checkProperty([] {
        const ContactModel model(ContactLaw::Split, *test::adhesivePair());
        const double compliance = *test::anyCompliance();
        const double pullOff = model.pullOffApproach(compliance);
        const double jumpIn = model.jumpInApproach(compliance);
        RC_ASSERT(pullOff <= jumpIn);
        const double between = pullOff + (*test::fraction() * (jumpIn - pullOff));
        const double margin = 1e-12 * (std::abs(pullOff) + std::abs(jumpIn));
        RC_PRE(between > pullOff + margin && between < jumpIn - margin);
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            const ContactState state = model.equilibrium(between, compliance, {branch});
            RC_ASSERT(state.branch == branch);
            RC_ASSERT(!state.jumped);
        }
        RC_ASSERT(model.equilibrium(jumpIn + margin, compliance, {ContactBranch::Far}).jumped);
        RC_ASSERT(model.equilibrium(pullOff - margin, compliance, {ContactBranch::Bonded}).jumped);
    });
}

TEST(ContactModelProperty, ForceIsContinuousAlongABranch) {
    test::checkProperty([] {
        const ContactModel model(ContactLaw::Split, *test::adhesivePair());
        const double compliance = *test::anyCompliance();
        const double pullOff = model.pullOffApproach(compliance);
        const double jumpIn = model.jumpInApproach(compliance);
        const double reach = *test::logUniform(1e-3, 10.0) * (std::abs(pullOff) + 1e-9);
        const double bottom = pullOff + (1e-9 * reach);
        const double top = jumpIn - (1e-9 * reach);
        const auto force = [&](double approach, ContactBranch branch) {
            return std::abs(model.equilibrium(approach, compliance, {branch}).force);
        };
        const double size =
            force(bottom, ContactBranch::Bonded) + force(bottom + reach, ContactBranch::Bonded);
        RC_ASSERT(test::stepWithin(model, {compliance, ContactBranch::Bonded}, bottom,
                                   bottom + reach) <= 1e-4 * size);
        RC_ASSERT(test::stepWithin(model, {compliance, ContactBranch::Far}, top - reach, top) <=
                  1e-4 * force(top, ContactBranch::Far));
    });
}

/// Work that the base does on the tip from `low` to `high` along one branch, on a grid that is fine
/// at both ends, where the force may be a square root of the distance.
double workAlong(const ContactModel& model, double compliance, ContactBranch branch, double low,
                 double high) {
    constexpr int kCells = 400;
    double work = 0.0;
    for (int i = 0; i < kCells; ++i) {
        const double u = (i + 0.5) / kCells;
        const double approach = low + ((high - low) * u * u * (3.0 - (2.0 * u)));
        const double width = (high - low) * 6.0 * u * (1.0 - u) / kCells;
        work += model.equilibrium(approach, compliance, {branch}).force * width;
    }
    return work;
}

/// Approach along one branch and retract along the other: the work left behind is what the two
/// jumps report as lost, never less than nothing.
TEST(ContactModelProperty, ALoopMakesNoEnergyAndLosesWhatTheJumpsReport) {
    test::checkProperty([] {
        const ContactModel model(ContactLaw::Split, *test::adhesivePair());
        const double compliance = *test::anyCompliance();
        const double pullOff = model.pullOffApproach(compliance);
        const double jumpIn = model.jumpInApproach(compliance);
        const double loop = workAlong(model, compliance, ContactBranch::Far, pullOff, jumpIn) -
                            workAlong(model, compliance, ContactBranch::Bonded, pullOff, jumpIn);
        const double margin = 1e-13 * (std::abs(pullOff) + std::abs(jumpIn));
        const double lost =
            model.equilibrium(jumpIn + margin, compliance, {ContactBranch::Far}).energyLost +
            model.equilibrium(pullOff - margin, compliance, {ContactBranch::Bonded}).energyLost;
        const double adhesion = model.pair().workOfAdhesion * model.pair().tipRadius;
        const double rounding = 1e-10 * adhesion * (std::abs(pullOff) + std::abs(jumpIn));
        RC_ASSERT(loop >= -rounding);
        RC_ASSERT(std::abs(lost - loop) <= (1e-4 * loop) + rounding);
    });
}

}  // namespace
}  // namespace asperity
