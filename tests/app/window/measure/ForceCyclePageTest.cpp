
#include "app/window/measure/ForceCycleControl.h"
#include "tests/ui/view/MapFixture.h"
#include "ui/view/MapTool.h"
#include "ui/widgets/Theme.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPainter>
#include <QTableView>
#include <QToolButton>

#include <cmath>

namespace asperity {
namespace {

ForceCycle forceCycleOf(double pullOff, double x) {
    ForceCycle entry;
    entry.cycle.phase = CyclePhase::Complete;
    entry.cycle.touchTime = 1.25;
    entry.cycle.position = {x, 50e-9};
    if (pullOff > 0.0) {
        entry.cycle.pullOff = Reading{pullOff, 0.2e-9};
        entry.cycle.adhesionWork = 12.1e-18;
        entry.cycle.areaSigma = 0.1e-18;
    }
    entry.cycle.maxForce = {.value = 5e-9, .sigma = 0.04e-9};
    entry.material = QStringLiteral("silicon oxide");
    entry.scan = QStringLiteral("steps.gsf");
    return entry;
}

/// Three cycles; the second one has no pull-off.
struct ForceCyclePageTest : ::testing::Test {
    ForceCyclePageTest() {
        page.model().append(forceCycleOf(9.5e-9, 30e-9));
        page.model().append(forceCycleOf(0.0, 60e-9));
        page.model().append(forceCycleOf(12.3e-9, 90e-9));
        table = page.findChild<QTableView*>();
    }
    [[nodiscard]] QString cell(int row, int column) const {
        return table->model()->index(row, column).data().toString();
    }
    QToolButton* button(const char* name) {
        return page.findChild<QToolButton*>(QString::fromLatin1(name));
    }

    ForceCyclePage page;
    QTableView* table;
};

TEST_F(ForceCyclePageTest, ShowsValuesInTheUnitsOfTheTitles) {
    EXPECT_EQ(cell(0, ForceCycleModel::Number), QStringLiteral("1"));
    EXPECT_EQ(cell(0, ForceCycleModel::Time), QStringLiteral("1.250"));
    EXPECT_EQ(cell(2, ForceCycleModel::X), QStringLiteral("0.0900"));
    EXPECT_EQ(cell(2, ForceCycleModel::PullOff), QStringLiteral("12.3"));
    EXPECT_EQ(cell(2, ForceCycleModel::Work), QStringLiteral("12.1"));
    EXPECT_EQ(cell(1, ForceCycleModel::PullOff), QStringLiteral("–"));
    EXPECT_EQ(cell(1, ForceCycleModel::SnapIn), QStringLiteral("–"));
    const QAbstractItemModel& model = page.model();
    EXPECT_EQ(
        model.headerData(ForceCycleModel::PullOff, Qt::Horizontal, Qt::DisplayRole).toString(),
        QStringLiteral("pull-off [nN]"));
    for (int column = 0; column < ForceCycleModel::ColumnCount; ++column) {
        EXPECT_FALSE(
            model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
    }
    const auto toolTip = [this](int row) {
        return page.model().index(row, ForceCycleModel::PullOff).data(Qt::ToolTipRole).toString();
    };
    EXPECT_TRUE(toolTip(2).endsWith(
        QStringLiteral("\n12.3 nN ± 0.2 (noise) ± ? (model and calibration: not computed)")))
        << toolTip(2).toStdString();
    ForceCycle known = forceCycleOf(12.3e-9, 90e-9);
    Budget budget{.value = 12.3e-9, .noise = 0.2e-9};
    budget.shares[static_cast<std::size_t>(UncertaintyInput::Stiffness)] = 1.2e-9;
    known.budgets = {{"pull_off_force_n", "pull-off force", "N", budget}};
    page.model().updateLast(known);
    EXPECT_TRUE(toolTip(2).endsWith(QStringLiteral("\n12.3 nN ± 0.2 (noise) ± 1.2 (k)")))
        << toolTip(2).toStdString();
}

TEST_F(ForceCyclePageTest, SortsByNumbersNotByTexts) {
    table->sortByColumn(ForceCycleModel::PullOff, Qt::DescendingOrder);
    EXPECT_EQ(cell(0, ForceCycleModel::PullOff), QStringLiteral("12.3"));
    EXPECT_EQ(cell(1, ForceCycleModel::PullOff), QStringLiteral("9.50"));
    EXPECT_EQ(cell(2, ForceCycleModel::PullOff), QStringLiteral("–"));
    table->sortByColumn(ForceCycleModel::PullOff, Qt::AscendingOrder);
    EXPECT_EQ(cell(0, ForceCycleModel::PullOff), QStringLiteral("9.50"));
    EXPECT_EQ(cell(1, ForceCycleModel::PullOff), QStringLiteral("12.3"));
    EXPECT_EQ(cell(2, ForceCycleModel::PullOff), QStringLiteral("–")) << "without a value: last";
}

TEST_F(ForceCyclePageTest, TheLastForceCycleGoesOn) {
    ForceCycle last = forceCycleOf(13.0e-9, 90e-9);
    page.model().updateLast(last);
    EXPECT_EQ(cell(2, ForceCycleModel::PullOff), QStringLiteral("13.0"));
    EXPECT_EQ(table->model()->rowCount(), 3);
}

TEST_F(ForceCyclePageTest, CopiesTheSelectedRowsInTheirOrder) {
    table->sortByColumn(ForceCycleModel::PullOff, Qt::DescendingOrder);
    QSignalSpy changed(&page, &ForceCyclePage::selectionChanged);
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

TEST_F(ForceCyclePageTest, ButtonsWorkWhereThereAreForceCycles) {
    EXPECT_TRUE(button("exportTouches")->isEnabled());
    QSignalSpy exported(&page, &ForceCyclePage::exportChosen);
    button("exportTouches")->click();
    EXPECT_EQ(exported.count(), 1);
    page.model().clear();
    for (const char* name : {"exportTouches", "copyTouches", "clearTouches"}) {
        EXPECT_FALSE(button(name)->isEnabled()) << name;
    }
}

struct ForceCycleMarksTest : test::MapFixture {};

TEST_F(ForceCycleMarksTest, AreNumberedDotsThatCanBeHidden) {
    ForceCycleMarks marks;
    map.addTool(marks);
    const auto count = [this](const Color& color) {
        return test::pixelsLike(map.grab().toImage(), toQColor(color));
    };
    const int without = count(kLightPalette.ink);
    marks.setForceCycles({{1, {40e-9, 40e-9}}, {2, {80e-9, 90e-9}}});
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

/// Where the tip touched it still is: its mark is drawn over the cycles.
TEST(ForceCycleMarks, TheNumberIsBesideTheMarkOfTheTip) {
    OverviewMap map;
    map.resize(320, 320);
    map.setSurface(fitSurface(test::flatMap()));
    const QPointF position(64e-9, 64e-9);
    const QPointF at = map.toPixel(position);
    ForceCycleMarks marks;
    marks.setForceCycles({{1, position}});
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
