
#include "app/window/fidelity/FidelityPanel.h"
#include "app/window/live/LivePanels.h"
#include "app/window/session/WindowMemory.h"
#include "core/scene/Scene.h"
#include "tests/app/window/SettledWindow.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/TestScenes.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace asperity::test {
namespace {

/// Share of pixels that are lighter than anything but letters and marks is on dark paper.
double lightShare(const QImage& image) {
    int light = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            light += image.pixelColor(x, y).lightness() > 150 ? 1 : 0;
        }
    }
    return static_cast<double>(light) / (image.width() * image.height());
}

class ThemeMenuTest : public ::testing::Test {
protected:
    void SetUp() override {
        theme::choose(ThemeChoice::Light);
        panels.showScene(&scene, QStringLiteral("a flat sample"));
        window.resize(1280, 800);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }
    void TearDown() override { theme::choose(ThemeChoice::Desktop); }
    QMenu& menu() {
        for (QMenu* menu : window.menuBar()->findChildren<QMenu*>()) {
            if (menu->title() == QStringLiteral("&Theme")) {
                return *menu;
            }
        }
        throw std::runtime_error("no menu for themes");
    }
    void choose(const char* title) {
        for (QAction* entry : menu().actions()) {
            if (entry->text() == QString::fromUtf8(title)) {
                entry->trigger();
            }
        }
        settle(panels);
    }
    QImage pictureOf(QWidget& widget) {
        widget.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&widget));
        settle(panels);
        return widget.grab().toImage();
    }

    Scene scene = buildScene(plainScene(), flatMap());
    MainWindow window;
    LivePanels panels{window};
    FidelityPanel* fidelity = new FidelityPanel(&window);
};

TEST_F(ThemeMenuTest, RepaintsAllWindowsWhileTheProgramRunsAndBackToTheSamePixels) {
    for (QWidget* shown : {static_cast<QWidget*>(&window), static_cast<QWidget*>(fidelity)}) {
        const QImage before = pictureOf(*shown);
        EXPECT_GT(lightShare(before), 0.6) << shown->windowTitle().toStdString();
        choose("&Dark");
        // The surface keeps its own colors.
        EXPECT_LT(lightShare(pictureOf(*shown)), 0.15) << shown->windowTitle().toStdString();
        choose("&Light");
        EXPECT_EQ(pictureOf(*shown), before) << shown->windowTitle().toStdString();
    }
}

/// A color that was taken once and never again is that of the light theme. Some
/// labels are first shown later, or get another parent.
TEST_F(ThemeMenuTest, NoLabelKeepsAColorOfTheThemeBefore) {
    const auto expectDark = [this](const char* when) {
        handleEvents();
        const ThemeColors& colors = theme::colors();
        for (const QLabel* label : window.findChildren<QLabel*>()) {
            const QColor shown = label->palette().color(QPalette::WindowText);
            const bool isOfTheme = shown == colors.ink || shown == colors.muted ||
                                   shown == colors.fault || shown == colors.caution;
            EXPECT_TRUE(isOfTheme)
                << when << ": " << shown.name().toStdString() << ", "
                << label->objectName().toStdString() << " " << label->text().toStdString();
        }
    };
    choose("&Dark");
    expectDark("at once");
    fidelity->show();
    expectDark("of what is shown first");
    Maximizer& maximizer = window.layout().maximizer();
    for (Card* card : window.cards()) {
        maximizer.toggle(*card);
        expectDark("enlarged");
        maximizer.restore();
        expectDark("and put back");
    }
}

TEST_F(ThemeMenuTest, TheLargeViewHasTheBackdropOfTheTheme) {
    const auto corner = [this] {
        settle(panels);
        return panels.view().frame().pixelColor(3, 3);
    };
    EXPECT_EQ(corner(), toQColor(kLightPalette.backdrop));
    choose("&Dark");
    EXPECT_EQ(corner(), toQColor(kDarkPalette.backdrop));
}

TEST_F(ThemeMenuTest, TheMenuMarksTheThemeThatIsChosen) {
    const auto checked = [this] {
        Q_EMIT menu().aboutToShow();
        QStringList names;
        for (const QAction* entry : menu().actions()) {
            if (entry->isChecked()) {
                names << entry->text();
            }
        }
        return names;
    };
    EXPECT_EQ(checked(), QStringList("&Light"));
    theme::choose(ThemeChoice::Dark);
    EXPECT_EQ(checked(), QStringList("&Dark"));
    theme::choose(ThemeChoice::Desktop);
    EXPECT_EQ(checked(), QStringList("&As the desktop"));
}

TEST_F(ThemeMenuTest, TheThemeIsRememberedByTheNextSession) {
    const ScratchFolder folder;
    const auto settings = [&] {
        return std::make_unique<QSettings>(QString::fromStdString(folder.file("a.ini").string()),
                                           QSettings::IniFormat);
    };
    {
        const WindowMemory memory(window, panels, settings());
        choose("&Dark");
    }
    theme::choose(ThemeChoice::Desktop);
    ASSERT_FALSE(theme::isDark());
    const WindowMemory memory(window, panels, settings());
    EXPECT_EQ(theme::choice(), ThemeChoice::Dark);
    EXPECT_TRUE(theme::isDark());
}

}  // namespace
}  // namespace asperity::test
