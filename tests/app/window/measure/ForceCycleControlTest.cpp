#include "app/window/measure/ForceCycleControl.h"

#include "app/window/live/OverviewPanel.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/core/haptics/cycle/SpringContact.h"
#include "ui/view/OverviewMap.h"

#include <QCheckBox>
#include <QToolButton>

namespace asperity::test {
namespace {

class ForceCycleControlTest : public ControlFixture {
protected:
    ForceCycleControlTest() {
        useFlatScene();
        contact.sample.output.model.tip.head<2>() = Vector2(30e-9, 40e-9);
        contact.onTick = [this] { cycles.take(contact.sample); };
    }
    ForceCycleModel& model() { return cycles.page().model(); }
    /// Some frames: a cycle under way is shown a few times a second.
    void frames() {
        for (int i = 0; i < 8; ++i) {
            cycles.show();
        }
    }

    ForceCycleControl& cycles = stage.add<ForceCycleControl>();
    SpringContact contact{SpringContact::kSigma};
};

TEST_F(ForceCycleControlTest, EachForceCycleIsARowThatGoesOnUntilItIsOff) {
    contact.moveTo(-2e-9);
    EXPECT_EQ(model().rowCount(), 0) << "rows come with a frame";
    cycles.show();
    ASSERT_EQ(model().rowCount(), 1);
    EXPECT_FALSE(model().forceCycles()[0].cycle.pullOff);
    contact.moveTo(4e-9);
    frames();
    ASSERT_EQ(model().rowCount(), 1);
    const ContactCycle& cycle = model().forceCycles()[0].cycle;
    EXPECT_TRUE(cycle.complete());
    EXPECT_NEAR(cycle.pullOff.value().value, SpringContact::kPull, 3.0 * SpringContact::kSigma);
    EXPECT_EQ(cycle.position, Vector2(30e-9, 40e-9));
    EXPECT_EQ(model().forceCycles()[0].material, QStringLiteral("polystyrene"));
    contact.oneCycle();
    contact.oneCycle();
    cycles.show();
    EXPECT_EQ(model().rowCount(), 3) << "two within a frame";
}

TEST_F(ForceCycleControlTest, ForceCyclesStayOverAChangeOfTheScene) {
    contact.oneCycle();
    cycles.show();
    useFlatScene();
    contact = SpringContact(SpringContact::kSigma);
    contact.onTick = [this] { cycles.take(contact.sample); };
    contact.moveTo(-2e-9);
    cycles.show();
    EXPECT_EQ(model().rowCount(), 2);
}

TEST_F(ForceCycleControlTest, ClearForgetsAllAndAForceCycleThatGoesOnStartsNoRow) {
    contact.moveTo(-2e-9);
    cycles.show();
    cycles.page().findChild<QToolButton*>("clearTouches")->click();
    contact.moveTo(-1.5e-9);
    cycles.show();
    EXPECT_EQ(model().rowCount(), 0);
    contact.moveTo(4e-9);
    contact.oneCycle();
    cycles.show();
    EXPECT_EQ(model().rowCount(), 1);
}

TEST_F(ForceCycleControlTest, MarksTheForceCyclesOnTheScanWhileThatIsWanted) {
    OverviewMap& map = panels.overview().map();
    map.resize(300, 300);
    const auto picture = [&map] { return map.grab().toImage(); };
    const QImage without = picture();
    contact.oneCycle();
    cycles.show();
    EXPECT_NE(picture(), without);
    cycles.page().findChild<QCheckBox*>("markTouches")->setChecked(false);
    EXPECT_EQ(picture(), without);
}

TEST_F(ForceCycleControlTest, ExportsATableThatReadsBackToTheSameBits) {
    contact.oneCycle();
    contact.moveTo(-1e-9);
    cycles.show();
    const std::filesystem::path file = folder.file("touches.csv");
    cycles.writeTo(file);
    const CsvTable table = readCsv(file);
    ASSERT_EQ(table.rows(), 2U);
    const ContactCycle& cycle = model().forceCycles()[0].cycle;
    EXPECT_EQ(table.number(0, "number"), 1.0);
    EXPECT_EQ(table.number(0, "x_m"), 30e-9);
    EXPECT_EQ(table.number(0, "pull_off_force_n"), cycle.pullOff->value);
    EXPECT_EQ(table.number(0, "adhesion_work_j"), cycle.adhesionWork);
    EXPECT_EQ(table.number(0, "contact_stiffness_n_m"), cycle.stiffness->value);
    EXPECT_EQ(table.number(0, "max_force_n"), cycle.maxForce->value);
    EXPECT_EQ(table.number(0, "max_force_sigma_n"), cycle.maxForce->sigma);
    EXPECT_NEAR(table.number(0, "max_force_model_sigma_n"), 0.1 * cycle.maxForce->value,
                0.01 * cycle.maxForce->value)
        << "the lever is known to a tenth";
    EXPECT_GT(table.number(0, "pull_off_force_model_sigma_n"), 0.05 * cycle.pullOff->value);
    EXPECT_EQ(table.text(1, "max_force_model_sigma_n"), "") << "it is in contact";
    EXPECT_EQ(table.number(0, "hysteresis_j"), cycle.closedHysteresis().value().value);
    EXPECT_EQ(table.text(1, "hysteresis_j"), "") << "it is in contact";
    EXPECT_EQ(table.text(0, "snap_in_force_n"), "") << "nothing pulled";
    EXPECT_EQ(table.text(1, "off_s"), "") << "it is in contact";
    EXPECT_EQ(table.text(0, "material"), "polystyrene");
    EXPECT_EQ(complaint(), "");
}

TEST_F(ForceCycleControlTest, SaysWhyATableCannotBeWritten) {
    contact.oneCycle();
    cycles.show();
    cycles.writeTo(folder.file("no such folder") / "touches.csv");
    EXPECT_NE(complaint().find("no such folder"), std::string::npos);
}

}  // namespace
}  // namespace asperity::test
