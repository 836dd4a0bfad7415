#include "app/window/Stage.h"
#include "app/window/lab/Features.h"
#include "app/window/live/LivePanels.h"
#include "ui/shell/CheatSheet.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/view/PixelView.h"
#include "ui/widgets/HeldKeys.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace asperity {
namespace {

std::string nameOf(const QAction& action) { return action.text().toStdString(); }

/// Entries that files and materials name: the program cannot choose their letters.
bool isNamedByData(const QAction& action) { return action.property("namedByData").toBool(); }

/// Menus and all below them.
void collectMenus(QMenu& menu, std::vector<QMenu*>& menus) {
    menus.push_back(&menu);
    for (const QAction* action : menu.actions()) {
        if (action->menu() != nullptr) {
            collectMenus(*action->menu(), menus);
        }
    }
}

std::vector<QMenu*> menusOf(const QMenuBar& bar) {
    std::vector<QMenu*> menus;
    for (const QAction* action : bar.actions()) {
        collectMenus(*action->menu(), menus);
    }
    return menus;
}

class Keys : public ::testing::Test {
protected:
    Keys() { addFeatures(stage); }

    /// Of all actions, in menus or not.
    std::vector<std::pair<QKeySequence, const QAction*>> shortcuts() {
        std::vector<std::pair<QKeySequence, const QAction*>> found;
        for (const QAction* action : window.findChildren<QAction*>()) {
            for (const QKeySequence& shortcut : action->shortcuts()) {
                found.emplace_back(shortcut, action);
            }
        }
        return found;
    }

    MainWindow window;
    LivePanels panels{window};
    Stage stage{window, panels};
};

/// An action of one widget only, such as "Copy view", may share its key with fields that handle it
/// themselves, but not with an action of the window.
TEST_F(Keys, NoTwoActionsShareAShortcut) {
    std::map<std::string, const QAction*> taken;
    for (const auto& [shortcut, action] : shortcuts()) {
        const auto [earlier, isNew] =
            taken.emplace(shortcut.toString(QKeySequence::PortableText).toStdString(), action);
        EXPECT_TRUE(isNew || earlier->second == action)
            << earlier->first << ": " << nameOf(*earlier->second) << ", " << nameOf(*action);
    }
    EXPECT_GT(taken.size(), 10U);
}

TEST_F(Keys, NoActionTakesAKeyOfTheDeviceOrTheView) {
    for (const auto& [shortcut, action] : shortcuts()) {
        for (int i = 0; i < static_cast<int>(shortcut.count()); ++i) {
            const auto code = static_cast<unsigned int>(shortcut[static_cast<uint>(i)]);
            const int key =
                static_cast<int>(code & ~static_cast<unsigned int>(Qt::KeyboardModifierMask));
            const auto modifiers = Qt::KeyboardModifiers(
                static_cast<int>(code & static_cast<unsigned int>(Qt::KeyboardModifierMask)));
            EXPECT_FALSE(HeldKeys::takes(key, modifiers)) << nameOf(*action);
            EXPECT_FALSE(GestureWidget::takes(key, modifiers)) << nameOf(*action);
        }
    }
}

/// A list below a menu, such as that of the panels, needs none.
TEST_F(Keys, EveryEntryOfAMenuHasAMnemonicOfItsOwn) {
    for (const QMenu* menu : menusOf(*window.menuBar())) {
        const bool isList = !window.menuBar()->actions().contains(menu->menuAction());
        std::map<QString, std::string> taken;
        for (const QAction* action : menu->actions()) {
            if (action->isSeparator() || isNamedByData(*action)) {
                continue;
            }
            const QString key = QKeySequence::mnemonic(action->text()).toString();
            EXPECT_TRUE(isList || !key.isEmpty()) << nameOf(*action) << " has none";
            const auto [earlier, isNew] = taken.emplace(key, nameOf(*action));
            EXPECT_TRUE(isNew || key.isEmpty()) << earlier->second << ", " << nameOf(*action);
        }
    }
    std::set<QString> bar;
    for (const QAction* menu : window.menuBar()->actions()) {
        EXPECT_TRUE(bar.insert(QKeySequence::mnemonic(menu->text()).toString()).second)
            << nameOf(*menu);
    }
}

TEST_F(Keys, EveryEntrySaysWhatItDoes) {
    for (const QAction* action : entriesOf(*window.menuBar())) {
        EXPECT_FALSE(action->text().isEmpty());
        if (!isNamedByData(*action)) {
            // Qt makes a tip of the text, less its marks, where none is set.
            EXPECT_NE(plainText(action->text()).remove(QStringLiteral("…")), action->toolTip())
                << nameOf(*action);
            EXPECT_GT(action->toolTip().size(), 8) << nameOf(*action);
        }
    }
}

/// The list is made from the same tables that the window works by.
TEST_F(Keys, TheCheatSheetListsEachShortcutAndAllThatMovesTheTip) {
    QString all;
    for (const HelpSection& section : windowHelp(*window.menuBar())) {
        for (const InputHelp& line : section.lines) {
            EXPECT_FALSE(line.input.isEmpty());
            EXPECT_FALSE(line.effect.isEmpty()) << line.input.toStdString();
            all += line.input + QStringLiteral(" | ") + line.effect + QLatin1Char('\n');
        }
    }
    for (const QAction* action : entriesOf(*window.menuBar())) {
        for (const QKeySequence& shortcut : action->shortcuts()) {
            EXPECT_TRUE(
                all.contains(shortcut.toString(QKeySequence::NativeText) + QStringLiteral(" | ")) ||
                all.contains(shortcut.toString(QKeySequence::NativeText) + QStringLiteral(", ")))
                << nameOf(*action);
        }
    }
    for (const char* input :
         {"Left, Right, Up, Down | ", "PgUp | ", "PgDown | ", "Left drag | ", "Wheel | ", "Esc | ",
          "Double click on the whole scan | ", "Right click on a plot | "}) {
        EXPECT_TRUE(all.contains(QString::fromUtf8(input))) << input << "\n" << all.toStdString();
    }
}

}  // namespace
}  // namespace asperity
