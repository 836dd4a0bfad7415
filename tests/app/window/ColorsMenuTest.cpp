#include "ui/view/ColorsMenu.h"

#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QWidget>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

class ColorsMenuTest : public ::testing::Test {
protected:
    ColorsMenuTest() {
        QObject::connect(&colors, &ColorsMenu::lookChosen,
                         [this](const SurfaceLook& look) { chosen = look; });
    }
    QAction& entry(const char* name) { return *menu->findChild<QAction*>(name); }

    QWidget window;
    QMenu* menu = new QMenu(&window);
    ColorsMenu& colors = *new ColorsMenu(*menu);
    SurfaceLook chosen;
};

TEST_F(ColorsMenuTest, EachQuantityKeepsItsColorMapAndRange) {
    entry("colorMap.gold").trigger();
    entry("colorRange.percent").trigger();
    EXPECT_EQ(chosen.of(SurfaceQuantity::Height).map, ColorMap::Gold);
    EXPECT_EQ(chosen.of(SurfaceQuantity::Height).rule, RangeRule::Percent);
    entry("colorBy.slope").trigger();
    EXPECT_EQ(chosen.quantity, SurfaceQuantity::Slope);
    EXPECT_TRUE(entry("colorMap.standard").isChecked());
    EXPECT_TRUE(entry("colorRange.full").isChecked());
    entry("colorBy.displacement").trigger();
    EXPECT_TRUE(entry("colorMap.diverging").isChecked()) << "of either sign";
    entry("colorBy.height").trigger();
    EXPECT_TRUE(entry("colorMap.gold").isChecked());
    EXPECT_TRUE(entry("colorRange.percent").isChecked());
}

TEST_F(ColorsMenuTest, AnotherRangeUndoesThePin) {
    entry("colorRange.pin").trigger();
    EXPECT_TRUE(chosen.of(SurfaceQuantity::Height).pinned);
    entry("colorRange.permille").trigger();
    EXPECT_FALSE(chosen.of(SurfaceQuantity::Height).pinned);
    EXPECT_FALSE(entry("colorRange.pin").isChecked());
}

TEST_F(ColorsMenuTest, AnOwnRangeIsTypedInTheUnitThatIsShown) {
    colors.setShown(QStringLiteral("m"), 1e-9, 40e-9);
    entry("colorRange.own").trigger();
    auto* dialog = window.findChild<NumbersDialog*>("colorRangeDialog");
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(chosen.of(SurfaceQuantity::Height).rule, RangeRule::Full) << "not before";
    EXPECT_TRUE(entry("colorRange.full").isChecked());
    const QList<NumberBox*> boxes = dialog->findChildren<NumberBox*>();
    ASSERT_EQ(boxes.size(), 2);
    EXPECT_DOUBLE_EQ(boxes[0]->value(), 1.0);
    EXPECT_EQ(boxes[1]->suffix(), QStringLiteral(" nm"));
    boxes[0]->setValue(12.5);
    boxes[1]->setValue(3.0);
    dialog->finish();
    EXPECT_EQ(chosen.of(SurfaceQuantity::Height).rule, RangeRule::Full) << "upside down: refused";
    boxes[1]->setValue(30.0);
    dialog->finish();
    EXPECT_EQ(chosen.of(SurfaceQuantity::Height).rule, RangeRule::Own);
    EXPECT_DOUBLE_EQ(chosen.of(SurfaceQuantity::Height).low, 12.5e-9);
    EXPECT_DOUBLE_EQ(chosen.of(SurfaceQuantity::Height).high, 30e-9);
}

TEST_F(ColorsMenuTest, WhatCannotBeShownSaysWhy) {
    colors.refuse(SurfaceQuantity::Certainty, QStringLiteral("no imaging tip"));
    EXPECT_FALSE(entry("colorBy.certainty").isEnabled());
    EXPECT_EQ(entry("colorBy.certainty").toolTip(), QStringLiteral("no imaging tip"));
    colors.refuse(SurfaceQuantity::Certainty, {});
    EXPECT_TRUE(entry("colorBy.certainty").isEnabled());
    EXPECT_FALSE(entry("colorBy.certainty").toolTip().isEmpty());
}

TEST_F(ColorsMenuTest, OffersTheOtherChannelsOfTheFile) {
    auto* channels = menu->findChild<QMenu*>("colorChannels");
    EXPECT_FALSE(channels->menuAction()->isEnabled());
    colors.setChannels({QStringLiteral("Phase"), QStringLiteral("A & B")});
    EXPECT_TRUE(channels->menuAction()->isEnabled());
    channels->actions()[1]->trigger();
    EXPECT_EQ(chosen.quantity, SurfaceQuantity::Channel);
    EXPECT_EQ(chosen.channel, QStringLiteral("A & B"));
    EXPECT_FALSE(entry("colorBy.height").isChecked());
    EXPECT_TRUE(channels->actions()[1]->isChecked());
}

TEST_F(ColorsMenuTest, EveryEntryHasAToolTip) {
    for (const QAction* action : menu->actions()) {
        EXPECT_TRUE(action->isSeparator() || !action->toolTip().isEmpty())
            << action->text().toStdString();
    }
}

}  // namespace
}  // namespace asperity::test
