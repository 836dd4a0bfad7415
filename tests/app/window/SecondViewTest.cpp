#include "ui/view/SecondView.h"

#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "core/Units.h"
#include "tests/support/TestScenes.h"
#include "tests/support/Waits.h"
#include "tests/ui/view/ViewMoments.h"
#include "ui/plot/CopyablePlot.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QComboBox>
#include <QSignalSpy>
#include <QtTest>

#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

namespace asperity::test {
namespace {

class SecondViewTest : public ::testing::Test {
protected:
    void SetUp() override {
        panels.showScene(&scene, QStringLiteral("a flat sample"));
        window.resize(1280, 800);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }
    void TearDown() override { panels.showScene(nullptr, {}); }
    SecondView& second() { return panels.second(); }

    Scene scene = flatScene();
    ViewMoments moments = momentsOf(scene);
    MainWindow window;
    LivePanels panels{window};
};

TEST_F(SecondViewTest, DoesNothingWhileItIsHidden) {
    window.menus().entry("secondView").trigger();
    EXPECT_FALSE(second().isVisible());
    QSignalSpy frames(&second().space(), &ZoomView::frameRendered);
    second().showSnapshot(moments.deep);
    EXPECT_FALSE(second().section().section()) << "no section is made";
    EXPECT_FALSE(second().space().window()) << "no terrain either";
    EXPECT_EQ(frames.count(), 0);
}

TEST_F(SecondViewTest, BothViewsAreThereAtFirstAndEquallyWide) {
    EXPECT_TRUE(eventually([this] {
        return second().isVisible() && std::abs(panels.view().width() - second().width()) <= 2;
    })) << panels.view().width()
        << " and " << second().width();
}

TEST_F(SecondViewTest, ShowsASectionOrA3DView) {
    ASSERT_TRUE(second().isVisible());
    second().showSnapshot(moments.deep);
    EXPECT_TRUE(second().section().section());
    SecondViewSettings settings = second().settings();
    settings.content = SecondContent::Space;
    second().setSettings(settings);
    EXPECT_TRUE(second().space().isVisible());
    ASSERT_TRUE(eventually([this] { return second().space().isSettled(); }));
    EXPECT_FALSE(second().section().isVisible());
    EXPECT_FALSE(second().section().section()) << "what is not seen holds no scene";
    QSignalSpy frames(&second().space(), &ZoomView::frameRendered);
    second().showSnapshot(moments.deep);
    EXPECT_EQ(frames.count(), 1);
    EXPECT_TRUE(second().space().window());
    window.menus().entry("secondView").trigger();
    EXPECT_FALSE(second().space().window());
}

TEST_F(SecondViewTest, TheSectionCopiesSurfaceAndTip) {
    const CopyablePlot& plot = *CopyablePlot::of(&second().section());
    EXPECT_EQ(plot.data(), QString());
    second().showSnapshot(moments.deep);
    const QStringList lines = plot.data().split('\n');
    EXPECT_TRUE(
        lines[0].startsWith(QStringLiteral("along, undeformed surface [m]\tz, undeformed surface "
                                           "[m]\talong, deformed surface [m]\t")));
    const ContactSection& section = *second().section().section();
    EXPECT_EQ(lines[1].section('\t', 3, 3).toDouble(), section.deformed.front().y());
}

TEST_F(SecondViewTest, HasADirectionAndOptionsOfItsOwn) {
    SecondViewSettings settings;
    settings.content = SecondContent::Space;
    settings.options.heightScale = 5.0;
    second().setSettings(settings);
    second().space().lookFrom(ViewDirection::Top);
    EXPECT_EQ(second().space().options().heightScale, 5.0);
    EXPECT_EQ(panels.view().options().heightScale, 1.0);
    EXPECT_NE(panels.view().camera().out(), second().space().camera().out());
}

TEST_F(SecondViewTest, TheDirectionOfTheSectionIsTyped) {
    auto* direction = second().findChild<NumberBox*>("sectionDirection");
    direction->setValue(45.0);
    EXPECT_NEAR(second().section().azimuth(), std::numbers::pi / 4.0, 1e-12);
    EXPECT_EQ(second().settings().azimuth, 45.0);
}

TEST_F(SecondViewTest, NamesTheDirectionThroughTheContact) {
    auto* direction = second().findChild<NumberBox*>("sectionDirection");
    Snapshot moment = moments.deep;
    TipState& state = moment.sample.output.model;
    state.closest.point.x() = state.tip.x();
    state.closest.point.y() = state.tip.y() + 0.3 * second().section().halfWidth();
    second().showSnapshot(moment);
    EXPECT_EQ(direction->value(), 90.0);
    EXPECT_TRUE(second().settings().followsContact);
}

TEST_F(SecondViewTest, OneCrossHairIsInAllViews) {
    panels.view().showSnapshot(moments.deep);
    second().showSnapshot(moments.deep);
    Q_EMIT second().section().positionHovered(70.0_nm, 60.0_nm);
    ASSERT_TRUE(panels.view().crossHair());
    EXPECT_EQ(*panels.view().crossHair(), Vector2(70.0_nm, 60.0_nm));
    OverviewMap& map = panels.overview().map();
    ASSERT_TRUE(map.crossHair());
    EXPECT_EQ(map.crossHair()->x(), 70.0_nm);
    Q_EMIT map.positionHovered(20.0_nm, 30.0_nm);
    EXPECT_EQ(*panels.view().crossHair(), Vector2(20.0_nm, 30.0_nm));
    Q_EMIT panels.view().pointerLeft();
    EXPECT_FALSE(panels.view().crossHair());
    EXPECT_FALSE(map.crossHair());
}

TEST_F(SecondViewTest, MovesTheTipAsTheLargeViewDoes) {
    QSignalSpy dragged(&panels.view(), &ZoomView::tipDragged);
    Q_EMIT second().space().tipDragged(1e-9, 2e-9);
    ASSERT_EQ(dragged.count(), 1);
    EXPECT_EQ(dragged[0][1].toDouble(), 2e-9);
}

}  // namespace
}  // namespace asperity::test
