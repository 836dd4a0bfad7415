#include "ui/shell/MainWindow.h"

#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"
#include "tests/support/Waits.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStatusBar>
#include <QStyleOptionComboBox>
#include <QtTest>

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace asperity::test {
namespace {

bool holdsText(const QWidget& widget) {
    return qobject_cast<const QLabel*>(&widget) != nullptr ||
           qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
}

std::string nameOf(const QWidget& widget) {
    const auto* label = qobject_cast<const QLabel*>(&widget);
    return (widget.metaObject()->className() + (" " + widget.objectName()) +
            (label != nullptr ? " " + label->text() : QString()))
        .toStdString();
}

/// Those whose text has too little room, or that lie in part outside of what holds them.
std::string cutIn(const QWidget& whole) {
    std::string cut;
    for (const QWidget* widget : whole.findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(&whole) || widget->window() != &whole || !holdsText(*widget)) {
            continue;
        }
        const bool elides = widget->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
        const bool isNarrow = !elides && widget->width() < widget->minimumSizeHint().width();
        if (isNarrow || widget->height() < widget->minimumSizeHint().height() - 1 ||
            !widget->parentWidget()->rect().contains(widget->geometry())) {
            cut += nameOf(*widget) + "; ";
        }
    }
    return cut;
}

class MainWindowTest : public ::testing::Test {
protected:
    void showAt(const QSize& size) {
        panels.showScene(&scene, QStringLiteral("a flat sample"));
        window.resize(size);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        handleEvents();
        ASSERT_EQ(window.size(), size) << "it is not too large for that";
    }
    QScrollArea& scroller() { return *window.findChild<QScrollArea*>(QStringLiteral("live")); }

    Scene scene = buildScene(plainScene(), flatMap());
    MainWindow window;
    LivePanels panels{window};
};

TEST_F(MainWindowTest, OpensOnTheScreen) {
    EXPECT_TRUE(window.screen()->availableGeometry().contains(window.geometry()));
}

/// It was drawn over the loop's numbers.
TEST_F(MainWindowTest, AMessageFromBeforeTheWindowOpenedHasTheBottomLineAlone) {
    window.tell(QStringLiteral("scan.gsf"));
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    const auto* loop = window.findChild<QLabel*>(QStringLiteral("loopState"));
    EXPECT_FALSE(loop->isVisible());
    window.tell(QString());
    EXPECT_TRUE(loop->isVisible());
}

TEST_F(MainWindowTest, CutsNothingFromASmallScreenToALargeOne) {
    for (const QSize& size : {QSize(900, 658), QSize(1280, 800), QSize(1920, 1080)}) {
        showAt(size);
        EXPECT_TRUE(eventually([this] { return cutIn(window).empty(); }))
            << size.width() << " x " << size.height() << ": " << cutIn(window);
        EXPECT_LE(scroller().widget()->width(), scroller().viewport()->width());
    }
}

TEST_F(MainWindowTest, FitsASmallScreenWithAllOfTheTimingAndASecondView) {
    window.menus().entry("loopTiming").setChecked(true);
    window.menus().entry("secondView").setChecked(true);
    panels.setEmergencyStop(true);
    showAt({900, 658});
    EXPECT_TRUE(eventually([this] { return cutIn(window).empty(); })) << cutIn(window);
    EXPECT_TRUE(window.findChild<QLabel*>(QStringLiteral("tickTime"))->isVisible());
    EXPECT_TRUE(window.findChild<QLabel*>(QStringLiteral("hint"))
                    ->text()
                    .startsWith(QStringLiteral("Esc: forces off")));
}

TEST_F(MainWindowTest, TheLargeViewNeverVanishes) {
    auto* page = new QLabel(QStringLiteral("a tool"));
    page->setMinimumSize(400, 2000);
    window.addTool(page, QStringLiteral("Tool"));
    window.showTool(page);
    showAt({900, 658});
    for (QSplitter* splitter : window.layout().splitters()) {
        splitter->setSizes({1, 5000, 5000});
    }
    handleEvents();
    EXPECT_GE(panels.view().width(), 170);
    EXPECT_GE(panels.view().height(), 150);
}

TEST_F(MainWindowTest, ReturnPressesTheButtonThatHasTheFocus) {
    auto* page = new QPushButton(QStringLiteral("Start a tool"));
    QSignalSpy pressed(page, &QPushButton::clicked);
    window.addTool(page, QStringLiteral("Tool"));
    window.showTool(page);
    showAt({1280, 800});
    page->setFocus();
    QTest::keyClick(page, Qt::Key_Return);
    EXPECT_EQ(pressed.count(), 1);
}

TEST_F(MainWindowTest, AsksBeforeItClosesWhileSomethingWouldEnd) {
    QString reason = QStringLiteral("A study is under way.");
    window.askBeforeClosing([&reason] { return reason; });
    showAt({1280, 800});
    const auto questions = [this] {
        return window.findChildren<QMessageBox*>(QString::fromUtf8(kAskWhether));
    };
    EXPECT_FALSE(window.close());
    EXPECT_FALSE(window.close()) << "Alt+F4 once more";
    ASSERT_EQ(questions().size(), 1);
    EXPECT_EQ(questions().front()->text(), reason);
    questions().front()->reject();
    EXPECT_TRUE(window.isVisible());
    EXPECT_TRUE(eventually([&] { return questions().empty(); }));
    EXPECT_FALSE(window.close());
    for (QAbstractButton* button : questions().front()->buttons()) {
        if (questions().front()->buttonRole(button) == QMessageBox::AcceptRole) {
            button->click();
            break;
        }
    }
    EXPECT_FALSE(window.isVisible());
}

TEST_F(MainWindowTest, ClosesWithoutAQuestionWhereNothingWouldEnd) {
    window.askBeforeClosing([] { return QString(); });
    showAt({1280, 800});
    EXPECT_TRUE(window.close());
}

TEST_F(MainWindowTest, PanelsThatDoNotFitAreScrolledTo) {
    showAt({900, 658});
    QScrollBar& bar = *scroller().verticalScrollBar();
    ASSERT_GT(bar.maximum(), 0);
    scroller().ensureWidgetVisible(window.cards().back());
    EXPECT_GT(bar.value(), 0);
}

TEST_F(MainWindowTest, AFoldedPanelLeavesItsRoomToTheOthers) {
    showAt({1280, 800});
    Card& first = *window.cards().front();
    Card& last = *window.cards().back();
    const int before = last.height();
    first.setFolded(true);
    EXPECT_TRUE(eventually([&] { return last.height() > before; }));
    EXPECT_LT(first.height(), 40);
    first.setFolded(false);
    EXPECT_TRUE(eventually([&] { return last.height() == before; })) << last.height();
    for (Card* card : window.cards()) {
        card->setFolded(true);
    }
    EXPECT_TRUE(eventually([&] { return last.geometry().bottom() < 200; }))
        << "all stand at the top";
}

TEST_F(MainWindowTest, GoesWithANumberHalfTyped) {
    auto shown = std::make_unique<MainWindow>();
    auto live = std::make_unique<LivePanels>(*shown);
    live->showScene(&scene, QStringLiteral("a flat sample"));
    shown->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(shown.get()));
    QApplication::setActiveWindow(shown.get());
    auto& box = *shown->findChild<QAbstractSpinBox*>("setpoint");
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("oops"));
    live.reset();
    shown.reset();
}

/// The tool tip with the reason was gone with the focus before anybody saw it.
TEST_F(MainWindowTest, TheBottomLineSaysWhyANumberIsRefusedWhereverTheFocusGoes) {
    window.addSidePage(new QLineEdit, QStringLiteral("Scene"));  // where Tab goes from the last one
    showAt({1280, 800});
    QApplication::setActiveWindow(&window);
    for (const char* name : {"forceGain", "positionGain", "setpoint"}) {
        for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Tab}) {
            window.tell({});
            auto& box = *window.findChild<QAbstractSpinBox*>(name);
            box.setFocus();
            ASSERT_TRUE(box.hasFocus());
            box.selectAll();
            QTest::keyClicks(&box, QStringLiteral("oops"));
            QTest::keyClick(&box, end);
            EXPECT_FALSE(box.hasFocus()) << name;
            EXPECT_TRUE(panels.view().hasFocus() || end == Qt::Key_Tab) << name;
            QTest::qWait(400);  // the reason must not go with the focus
            EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("“oops” is not valid"))
                << name << ": " << window.statusBar()->currentMessage().toStdString();
        }
    }
}

/// Room for letters in a list's box.
int roomIn(const QComboBox& combo) {
    QStyleOptionComboBox option;
    option.initFrom(&combo);
    return combo.style()
               ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo)
               .width() -
           2;
}

/// "silicon oxide (a" and "Mouse and key" were cut in the middle of a word.
TEST_F(MainWindowTest, ListsOfTheTopRowShowTheirPresentTextOnASmallScreen) {
    ControlBar& controls = panels.controls();
    for (const QString& material :
         {QStringLiteral("polystyrene"), QStringLiteral("silicon oxide (assumed)"),
          QStringLiteral("silicone rubber (edited)")}) {
        for (const QString& device :
             {QStringLiteral("Scripted path"), QStringLiteral("Mouse and keyboard")}) {
            controls.setMaterials({material});
            controls.setDevices({device});
            controls.setPaths({QStringLiteral("Approach")});
            for (const QSize& size : {QSize(900, 658), QSize(1024, 700), QSize(1280, 800)}) {
                showAt(size);
                for (const ChoiceBox* list : controls.findChildren<ChoiceBox*>()) {
                    EXPECT_LE(list->fontMetrics().horizontalAdvance(list->currentText()),
                              roomIn(*list))
                        << size.width() << ": " << list->currentText().toStdString();
                    EXPECT_EQ(list->shownText(), list->currentText());
                }
                EXPECT_TRUE(eventually([&] { return cutIn(window).empty(); }))
                    << size.width() << ": " << cutIn(window);
            }
            EXPECT_LT(controls.height(), 60) << "one line at 1280";
        }
    }
}

TEST_F(MainWindowTest, ListsThatHaveRoomForTheirTextAreEquallyWide) {
    ControlBar& controls = panels.controls();
    controls.setMaterials({QStringLiteral("silicon oxide (assumed)")});
    controls.setDevices({QStringLiteral("Mouse and keyboard")});
    controls.setPaths({QStringLiteral("Approach")});
    showAt({1280, 800});
    const auto widthOf = [&](const char* name) {
        return controls.findChild<QComboBox*>(QString::fromUtf8(name))->width();
    };
    constexpr int kPixel = 1;  // what is left over goes to one of them
    EXPECT_NEAR(widthOf("device"), widthOf("material"), kPixel);
    EXPECT_NEAR(widthOf("path"), widthOf("material"), kPixel);
}

TEST_F(MainWindowTest, ATextOfMoreThan24LettersEndsInAnEllipsis) {
    ControlBar& controls = panels.controls();
    const QString text = QStringLiteral("a material with a name that goes on and on");
    controls.setMaterials({text});
    showAt({1024, 700});
    const auto& list = *controls.findChild<ChoiceBox*>(QStringLiteral("material"));
    EXPECT_TRUE(list.shownText().endsWith(QStringLiteral("…")));
    EXPECT_GE(list.shownText().size(), 23);
    EXPECT_LE(list.fontMetrics().horizontalAdvance(list.shownText()), roomIn(list));
}

}  // namespace
}  // namespace asperity::test
