#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/SplitLaw.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/core/contact/laws/ExpectedState.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace asperity {
namespace {

using test::expectClose;
using test::kLeverFoldTolerance;
using test::paperPair;
using test::ReferenceTable;

constexpr double kSplitTolerance = 1e-10;

/// The bonded curve of the split law at any contact or cohesive radius, stable or not.
class BondedCurve {
public:
    explicit BondedCurve(const ContactModel& model)
        : split_(*model.split())
        , units_(maugisUnits(
              {model.pair().tipRadius, model.pair().reducedModulus, split_.cohesiveWork}))
        , law_(model.lambda()) {}

    [[nodiscard]] LawPoint at(double contactRadius, double cohesiveRadius) const {
        return withTail(contactRadius > 0.0
                            ? law_.atContactRadius(contactRadius / units_.radius)
                            : law_.curve().noncontact(cohesiveRadius / units_.radius));
    }
    /// The state with the smallest force.
    [[nodiscard]] LawPoint pullOff() const { return withTail(law_.fold(MaugisControl::load())); }
    /// Distance of the surfaces on the axis as van der Waals forces count it [m].
    [[nodiscard]] double separationAt(double contactRadius, double cohesiveRadius) const {
        if (contactRadius > 0.0) {
            return kContactSeparation;
        }
        const MaugisPoint point = law_.curve().noncontact(cohesiveRadius / units_.radius);
        const double lift = 4.0 / 3.0 * law_.curve().lambda() * point.cohesiveRadius;
        return kContactSeparation - ((point.indentation + lift) * units_.indentation);
    }
    [[nodiscard]] const MaugisUnits& units() const { return units_; }

private:
    [[nodiscard]] LawPoint withTail(const MaugisPoint& point) const {
        return {.force = (point.force * units_.force) + split_.tailForce,
                .indentation = (point.indentation * units_.indentation) - split_.tailLift,
                .contactRadius = point.contactRadius * units_.radius,
                .cohesiveRadius = point.cohesiveRadius * units_.radius};
    }

    AdhesionSplit split_;
    MaugisUnits units_;
    MaugisDugdale law_;
};

double indentationUnit(const BondedCurve& curve) {
    return std::max(curve.units().indentation, kCohesiveRange);
}

/// All rows, those that no lever can hold too.
TEST(SplitCurve, IsTheReferenceStableOrNot) {
    const ReferenceTable table = test::referenceTable("T07_split_curve.csv");
    ASSERT_EQ(table.rows(), 134U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        EXPECT_EQ(table.number(row, "eps"), 0.1);
        const ContactModel model(ContactLaw::Split, paperPair(table.text(row, "material")));
        const double separation = table.number(row, "D_m");
        if (table.text(row, "region") == "tail") {
            const AttractiveTail& tail = *model.tail();
            expectClose(tail.attraction().force(separation), table.number(row, "P_N"),
                        kSplitTolerance);
            expectClose(tail.indentation(separation), table.number(row, "delta_m"),
                        kSplitTolerance);
            continue;
        }
        const BondedCurve curve(model);
        const double a = table.number(row, "a_m");
        const double c = table.number(row, "c_m");
        const LawPoint point = curve.at(a, c);
        EXPECT_EQ(a > 0.0, table.text(row, "region") == "contact");
        expectClose(point.cohesiveRadius, c, kSplitTolerance);
        expectClose(point.force, table.number(row, "P_N"), kSplitTolerance, curve.units().force);
        expectClose(point.indentation, table.number(row, "delta_m"), kSplitTolerance,
                    indentationUnit(curve));
        expectClose(curve.separationAt(a, c), separation, kSplitTolerance, indentationUnit(curve));
    }
}

class SplitCriticalStates : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(table.rows(), 3U); }

    [[nodiscard]] double cell(std::size_t row, const char* column) const {
        return table.number(row, column);
    }
    [[nodiscard]] ContactModel model(std::size_t row) const {
        return {ContactLaw::Split, paperPair(table.text(row, "material"))};
    }

    const ReferenceTable table = test::referenceTable("T07c_split_critical.csv");
};

TEST_F(SplitCriticalStates, HaveTheReferenceRangesAndInstability) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        EXPECT_EQ(cell(row, "eps"), 0.1);
        expectClose(kContactSeparation, cell(row, "D0_m"), 1e-15);
        expectClose(kCohesiveRange, cell(row, "hs_m"), 1e-15);
        const ContactModel contact = model(row);
        const AttractiveTail& tail = *contact.tail();
        const double end = tail.elasticInstability();
        expectClose(tail.indentation(end), cell(row, "snap_delta_m"), kSplitTolerance);
        expectClose(tail.attraction().force(end), cell(row, "snap_P_N"), kSplitTolerance);
    }
}

TEST_F(SplitCriticalStates, HaveTheReferenceJumpOff) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactState jumpOff = model(row).lastBonded(0.0);
        expectClose(jumpOff.force, cell(row, "do_P_N"), kSplitTolerance);
        expectClose(jumpOff.indentation, cell(row, "do_delta_m"), kSplitTolerance);
        expectClose(jumpOff.contactRadius, cell(row, "do_a_m"), kSplitTolerance);
        EXPECT_EQ(jumpOff.contactRadius > 0.0, table.text(row, "do_kind") == "contact");
    }
}

/// Under load the tail's constant force shifts the fold of the zone.
TEST_F(SplitCriticalStates, HaveTheReferencePullOff) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const BondedCurve curve(model(row));
        const LawPoint point = curve.pullOff();
        expectClose(point.force, cell(row, "po_P_N"), kSplitTolerance);
        expectClose(point.contactRadius, cell(row, "po_a_m"), kSplitTolerance);
        expectClose(point.indentation, cell(row, "po_delta_m"), kSplitTolerance,
                    indentationUnit(curve));
    }
}

class SplitOnALever : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(table.rows(), 9U); }

    [[nodiscard]] double cell(std::size_t row, const char* column) const {
        return table.number(row, column);
    }
    [[nodiscard]] ContactModel model(std::size_t row) const {
        return {ContactLaw::Split, paperPair(table.text(row, "material"))};
    }

    const ReferenceTable table = test::referenceTable("T21_split_spring_critical.csv");
};

TEST_F(SplitOnALever, EndsItsTailWhereTheReferenceDoes) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        EXPECT_EQ(cell(row, "eps"), 0.1);
        const ContactModel contact = model(row);
        const AttractiveTail& tail = *contact.tail();
        const double compliance = 1.0 / cell(row, "k");
        const double end = tail.endSeparation(compliance);
        expectClose(end, cell(row, "Dj_m"), kLeverFoldTolerance);
        expectClose(tail.attraction().force(end), cell(row, "in_P_N"), kLeverFoldTolerance);
        expectClose(tail.approach(end, compliance), cell(row, "in_xb_m"), kSplitTolerance);
        const double joint = contact.split()->jointSeparation;
        EXPECT_EQ(end > joint * (1.0 + 1e-12), cell(row, "tail_fold") == 1.0);
    }
}

TEST_F(SplitOnALever, PullsOffAtTheReferenceState) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel contact = model(row);
        const double compliance = 1.0 / cell(row, "k");
        const ContactState last = contact.lastBonded(compliance);
        const double unit = indentationUnit(BondedCurve(contact));
        expectClose(last.force, cell(row, "off_P_N"), kLeverFoldTolerance);
        expectClose(last.indentation, cell(row, "off_delta_m"), kLeverFoldTolerance, unit);
        expectClose(last.contactRadius, cell(row, "off_a_m"), kLeverFoldTolerance);
        expectClose(last.cohesiveRadius, cell(row, "off_c_m"), kLeverFoldTolerance);
        expectClose(contact.pullOffApproach(compliance), cell(row, "off_xb_m"), kSplitTolerance);
    }
}

TEST_F(SplitOnALever, LandsInTheReferenceRegion) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel contact = model(row);
        const double compliance = 1.0 / cell(row, "k");
        const double jumpIn = contact.jumpInApproach(compliance);
        const ContactState landed = contact.equilibrium(jumpIn + (1e-14 * std::abs(jumpIn)),
                                                        compliance, {ContactBranch::Far});
        EXPECT_EQ(landed.region() == TipRegion::Contact, table.text(row, "land_kind") == "contact");
        EXPECT_EQ(contact.lastBonded(compliance).contactRadius > 0.0,
                  table.text(row, "off_kind") == "contact");
    }
}

TEST_F(SplitOnALever, SwingsToTheReferenceSeparationAfterPullOff) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const ContactModel contact = model(row);
        const double compliance = 1.0 / cell(row, "k");
        const double beyond = contact.pullOffApproach(compliance) * (1.0 + 1e-14);
        const ContactState gone = contact.equilibrium(beyond, compliance, {ContactBranch::Bonded});
        const AttractiveTail& tail = *contact.tail();
        expectClose(tail.attraction().separationAt(gone.force), cell(row, "after_D_m"),
                    kSplitTolerance);
        expectClose(gone.force, cell(row, "after_P_N"), kSplitTolerance);
    }
}

}  // namespace
}  // namespace asperity
