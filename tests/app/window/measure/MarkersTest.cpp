#include "app/window/measure/MarkerControl.h"
#include "tests/ui/view/MapFixture.h"
#include "ui/widgets/Theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include <limits>

namespace asperity {
namespace {

std::vector<Marker> twoMarkers() { return {{"grain", 40e-9, 40e-9}, {"edge", 90e-9, 100e-9}}; }

struct MarkerToolTest : test::MapFixture {
    MarkerToolTest() {
        use(tool);
        tool.setMarkers(twoMarkers());
    }

    MarkerTool tool;
};

TEST_F(MarkerToolTest, DrawsCrossAndNameAndTheSelectedOneStrongly) {
    const int ink = test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.ink));
    tool.setMarkers({});
    EXPECT_GT(ink, test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.ink)) + 15);
    tool.setMarkers(twoMarkers());
    EXPECT_EQ(test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.force)), 0);
    tool.setSelected(1);
    EXPECT_GT(test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.force)), 10);
}

TEST_F(MarkerToolTest, ADoubleClickSetsOneAndDoesNotTravel) {
    QSignalSpy wanted(&tool, &MarkerTool::markerWanted);
    QSignalSpy travels(&map, &OverviewMap::positionChosen);
    QTest::mouseDClick(&map, Qt::LeftButton, Qt::NoModifier, pixel(64, 20).toPoint());
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_NEAR(wanted[0][0].toPointF().x(), 64e-9, kNear);
    EXPECT_NEAR(wanted[0][0].toPointF().y(), 20e-9, kNear);
    EXPECT_EQ(travels.count(), 0);
}

TEST_F(MarkerToolTest, ADragMovesOneInOneStep) {
    QSignalSpy moved(&tool, &MarkerTool::moveWanted);
    QSignalSpy pressed(&tool, &MarkerTool::markerPressed);
    drag(90, 100, 60, 70);
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved[0][0].toInt(), 1);
    EXPECT_NEAR(moved[0][1].toPointF().x(), 60e-9, kNear);
    EXPECT_EQ(pressed[0][0].toInt(), 1);
    drag(10, 10, 30, 10);
    EXPECT_EQ(moved.count(), 1) << "nothing is there";
    EXPECT_EQ(cursorAt(60, 70), Qt::SizeAllCursor);
}

/// The page with two markers.
struct MarkersPageTest : ::testing::Test {
    MarkersPageTest() { page.setMarkers(twoMarkers(), {1.5e-9, -2e-9}, {}); }

    [[nodiscard]] QString cell(int row, int column) const {
        return page.model().index(row, column).data().toString();
    }
    QToolButton* button(const char* name) {
        return page.findChild<QToolButton*>(QString::fromLatin1(name));
    }

    MarkersPage page;
};

TEST_F(MarkersPageTest, ListsNamesAndPlacesWithUnits) {
    EXPECT_EQ(cell(0, MarkerModel::Name), QStringLiteral("grain"));
    EXPECT_EQ(cell(1, MarkerModel::X), QStringLiteral("0.0900"));
    EXPECT_EQ(cell(1, MarkerModel::Z), QStringLiteral("-2.00"));
    page.setMarkers(twoMarkers(), {1.5e-9, std::numeric_limits<double>::quiet_NaN()},
                    QStringLiteral("Reading the scan"));
    EXPECT_EQ(cell(1, MarkerModel::Z), QStringLiteral("–"));
    EXPECT_EQ(page.findChild<QLabel*>("markersState")->text(), QStringLiteral("Reading the scan"));
    EXPECT_EQ(page.model().headerData(MarkerModel::X, Qt::Horizontal, Qt::DisplayRole).toString(),
              QStringLiteral("x [µm]"));
    for (int column = 0; column < MarkerModel::kColumns; ++column) {
        EXPECT_FALSE(
            page.model().headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
    }
}

TEST_F(MarkersPageTest, TravelsToAndDeletesTheSelectedOne) {
    EXPECT_FALSE(button("travelToMarker")->isEnabled());
    QSignalSpy travel(&page, &MarkersPage::travelChosen);
    QSignalSpy removed(&page, &MarkersPage::deleteChosen);
    page.select(1);
    button("travelToMarker")->click();
    button("deleteMarker")->click();
    ASSERT_EQ(travel.count(), 1);
    EXPECT_EQ(travel[0][0].toInt(), 1);
    EXPECT_EQ(removed.count(), 1);
    page.setMarkers({twoMarkers().front()}, {0.0}, {});
    EXPECT_FALSE(button("deleteMarker")->isEnabled());
}

TEST_F(MarkersPageTest, ANewNameIsAskedForAndEmptyOnesAreNot) {
    QSignalSpy renamed(&page, &MarkersPage::renameChosen);
    auto* model = page.findChild<QTableView*>()->model();
    EXPECT_TRUE(model->setData(model->index(0, 0), QStringLiteral(" step ")));
    ASSERT_EQ(renamed.count(), 1);
    EXPECT_EQ(renamed[0][1].toString(), QStringLiteral("step"));
    EXPECT_FALSE(model->setData(model->index(0, 0), QStringLiteral("  ")));
    EXPECT_FALSE(model->setData(model->index(0, 0), QStringLiteral("grain")));
    EXPECT_EQ(renamed.count(), 1);
}

}  // namespace
}  // namespace asperity
