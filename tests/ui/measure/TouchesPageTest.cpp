#include "ui/measure/TouchesPage.h"

#include "tests/ui/measure/MapFixture.h"
#include "ui/Theme.h"
#include "ui/measure/TouchMarks.h"
#include "ui/panels/MapMarks.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPainter>
#include <QTableView>
#include <QToolButton>

#include <cmath>

namespace asperity {
namespace {

Touch touchOf(double pullOff, double x) {
    Touch touch;
    touch.cycle.phase = CyclePhase::Complete;
    touch.cycle.touchTime = 1.25;
    touch.cycle.place = {x, 50e-9};
    if (pullOff > 0.0) {
        touch.cycle.pullOff = Reading{pullOff, 0.2e-9};
        touch.cycle.adhesionWork = 12.1e-18;
        touch.cycle.areaSigma = 0.1e-18;
    }
    touch.cycle.maxForce = {.value = 5e-9, .sigma = 0.04e-9};
    touch.material = QStringLiteral("silicon oxide");
    touch.scan = QStringLiteral("steps.gsf");
    return touch;
}

/// Three touches; the second one has no pull-off.
struct TouchesPageTest : ::testing::Test {
    TouchesPageTest() {
        page.model().append(touchOf(9.5e-9, 30e-9));
        page.model().append(touchOf(0.0, 60e-9));
        page.model().append(touchOf(12.3e-9, 90e-9));
        table = page.findChild<QTableView*>();
    }
    [[nodiscard]] QString cell(int row, int column) const {
        return table->model()->index(row, column).data().toString();
    }
    QToolButton* button(const char* name) {
        return page.findChild<QToolButton*>(QString::fromLatin1(name));
    }

    TouchesPage page;
    QTableView* table;
};

TEST_F(TouchesPageTest, ShowsValuesInTheUnitsOfTheTitles) {
    EXPECT_EQ(cell(0, TouchModel::Number), QStringLiteral("1"));
    EXPECT_EQ(cell(0, TouchModel::Time), QStringLiteral("1.250"));
    EXPECT_EQ(cell(2, TouchModel::X), QStringLiteral("0.0900"));
    EXPECT_EQ(cell(2, TouchModel::PullOff), QStringLiteral("12.3"));
    EXPECT_EQ(cell(2, TouchModel::Work), QStringLiteral("12.1"));
    EXPECT_EQ(cell(1, TouchModel::PullOff), QStringLiteral("–"));
    EXPECT_EQ(cell(1, TouchModel::SnapIn), QStringLiteral("–"));
    const QAbstractItemModel& model = page.model();
    EXPECT_EQ(model.headerData(TouchModel::PullOff, Qt::Horizontal, Qt::DisplayRole).toString(),
              QStringLiteral("pull-off [nN]"));
    for (int column = 0; column < TouchModel::ColumnCount; ++column) {
        EXPECT_FALSE(
            model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
    }
    const auto toolTip = [this](int row) {
        return page.model().index(row, TouchModel::PullOff).data(Qt::ToolTipRole).toString();
    };
    EXPECT_TRUE(toolTip(2).endsWith(
        QStringLiteral("\n12.3 nN ± 0.2 (noise) ± ? (model and calibration: not computed)")))
        << toolTip(2).toStdString();
    Touch known = touchOf(12.3e-9, 90e-9);
    Budget budget{.value = 12.3e-9, .noise = 0.2e-9};
    budget.shares[static_cast<std::size_t>(UncertaintyInput::Stiffness)] = 1.2e-9;
    known.budgets = {{"pull_off_force_n", "pull-off force", "N", budget}};
    page.model().updateLast(known);
    EXPECT_TRUE(toolTip(2).endsWith(QStringLiteral("\n12.3 nN ± 0.2 (noise) ± 1.2 (k)")))
        << toolTip(2).toStdString();
}

TEST_F(TouchesPageTest, SortsByNumbersNotByTexts) {
    table->sortByColumn(TouchModel::PullOff, Qt::DescendingOrder);
    EXPECT_EQ(cell(0, TouchModel::PullOff), QStringLiteral("12.3"));
    EXPECT_EQ(cell(1, TouchModel::PullOff), QStringLiteral("9.50"));
    EXPECT_EQ(cell(2, TouchModel::PullOff), QStringLiteral("–"));
    table->sortByColumn(TouchModel::PullOff, Qt::AscendingOrder);
    EXPECT_EQ(cell(0, TouchModel::PullOff), QStringLiteral("9.50"));
    EXPECT_EQ(cell(1, TouchModel::PullOff), QStringLiteral("12.3"));
    EXPECT_EQ(cell(2, TouchModel::PullOff), QStringLiteral("–")) << "without a value: last";
}

TEST_F(TouchesPageTest, TheLastTouchGoesOn) {
    Touch last = touchOf(13.0e-9, 90e-9);
    page.model().updateLast(last);
    EXPECT_EQ(cell(2, TouchModel::PullOff), QStringLiteral("13.0"));
    EXPECT_EQ(table->model()->rowCount(), 3);
}

TEST_F(TouchesPageTest, CopiesTheSelectedRowsInTheirOrder) {
    table->sortByColumn(TouchModel::PullOff, Qt::DescendingOrder);
    QSignalSpy changed(&page, &TouchesPage::selectionChanged);
    table->selectRow(0);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_EQ(page.selected(), QSet<int>{3});
    button("copyTouches")->click();
    const QStringList lines =
        QApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[0].startsWith(QStringLiteral("no.\ttime [s]\tx [µm]")));
    EXPECT_TRUE(lines[1].startsWith(QStringLiteral("3\t1.250\t0.0900\t")));
    table->clearSelection();
    EXPECT_EQ(page.rowsAsText().count(QLatin1Char('\n')), 4) << "all without a selection";
}

TEST_F(TouchesPageTest, ButtonsWorkWhereThereAreTouches) {
    EXPECT_TRUE(button("exportTouches")->isEnabled());
    QSignalSpy exported(&page, &TouchesPage::exportChosen);
    button("exportTouches")->click();
    EXPECT_EQ(exported.count(), 1);
    page.model().clear();
    for (const char* name : {"exportTouches", "copyTouches", "clearTouches"}) {
        EXPECT_FALSE(button(name)->isEnabled()) << name;
    }
}

struct TouchMarksTest : test::MapFixture {};

TEST_F(TouchMarksTest, AreNumberedDotsThatCanBeHidden) {
    TouchMarks marks;
    map.addTool(marks);
    const auto count = [this](const Color& color) {
        return test::pixelsLike(map.grab().toImage(), toQColor(color));
    };
    const int without = count(kLightPalette.ink);
    marks.setTouches({{1, {40e-9, 40e-9}}, {2, {80e-9, 90e-9}}});
    EXPECT_GT(count(kLightPalette.ink), without + 30);
    EXPECT_EQ(count(kLightPalette.force), 0);
    marks.setSelected({2});
    EXPECT_GT(count(kLightPalette.force), 40);
    const QPoint dot = pixel(80, 90).toPoint();
    EXPECT_EQ(map.grab().toImage().pixelColor(dot), toQColor(kLightPalette.force));
    marks.setShown(false);
    EXPECT_EQ(count(kLightPalette.ink), without);
    EXPECT_EQ(count(kLightPalette.force), 0);
}

/// Where the tip touched it still is: its mark is drawn over the touches.
TEST(TouchMarks, TheNumberIsBesideTheMarkOfTheTip) {
    OverviewMap map;
    map.resize(320, 320);
    map.setSurface(fitSurface(test::flatMap()));
    const QPointF place(64e-9, 64e-9);
    const QPointF at = map.toPixel(place);
    TouchMarks marks;
    marks.setTouches({{1, place}});
    const auto drawn = [&](bool withTip) {
        QImage image(320, 320, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::darkGreen);
        QPainter painter(&image);
        marks.paint(painter, map);
        if (withTip) {
            drawTipMark(painter, at);
        }
        return image;
    };
    const QImage alone = drawn(false);
    const QImage below = drawn(true);
    int letters = 0;
    for (int y = 0; y < alone.height(); ++y) {
        for (int x = 0; x < alone.width(); ++x) {
            constexpr double kDot = 5.0;  // [px]
            const bool isDot = std::hypot(x - at.x(), y - at.y()) < kDot;
            if (!isDot && alone.pixelColor(x, y) != QColor(Qt::darkGreen)) {
                ++letters;
                EXPECT_EQ(below.pixelColor(x, y), alone.pixelColor(x, y)) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(letters, 30) << "the number and its plate";
}

}  // namespace
}  // namespace asperity
