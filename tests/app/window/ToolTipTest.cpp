#include "app/window/fidelity/FidelityPanel.h"
#include "tests/app/window/WindowFixture.h"
#include "ui/shell/PageTabs.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSplitter>
#include <QTabBar>
#include <QTextEdit>

#include <string_view>
#include <typeinfo>

namespace asperity::test {
namespace {

template <typename... Types>
bool isAny(const QWidget& widget) {
    return (... || (qobject_cast<const Types*>(&widget) != nullptr));
}

/// Parts of Qt's own widgets, which have the tool tip of the whole.
bool isPart(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    return widget.objectName().startsWith(QStringLiteral("qt_")) ||
           widget.testAttribute(Qt::WA_TransparentForMouseEvents) ||
           isAny<QScrollBar, QHeaderView>(widget) ||
           (parent != nullptr &&
            (isAny<QAbstractSpinBox, QComboBox, QTabBar, QMenuBar, QLineEdit>(*parent) ||
             parent->inherits("QComboBoxPrivateContainer") ||
             (isAny<QAbstractItemView>(*parent) && !isAny<QComboBox>(widget))));
}

/// Whether a user does something with it.
bool isInteractive(const QWidget& widget) {
    return isAny<QAbstractButton, QComboBox, QAbstractSpinBox, QLineEdit, QTabBar, QSlider,
                 QAbstractItemView, QTextEdit, QPlainTextEdit, QSplitterHandle>(widget) &&
           !widget.testAttribute(Qt::WA_TransparentForMouseEvents);
}

/// Whether our own code paints it.
bool isPainted(const QWidget& widget) {
    return std::string_view(typeid(widget).name()).find("8asperity") != std::string_view::npos &&
           widget.layout() == nullptr &&
           !isAny<QSplitter, QScrollArea, QTabWidget, QMainWindow, QLabel>(widget);
}

/// Whether it shows a user something that can be read.
bool isReading(const QWidget& widget) {
    const auto* label = qobject_cast<const QLabel*>(&widget);
    const bool isValue =
        label != nullptr && !label->objectName().isEmpty() && !label->text().isEmpty();
    return isValue || isAny<QProgressBar>(widget) || widget.inherits("QwtPlot") ||
           isPainted(widget);
}

/// The tool tip that appears over it: Qt asks its parents, too.
bool hasToolTip(const QWidget& widget) {
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
        for (int i = 0; i < bar->count(); ++i) {
            if (bar->tabToolTip(i).isEmpty()) {
                return false;
            }
        }
        return true;
    }
    if (isInteractive(widget)) {
        return !widget.toolTip().isEmpty();
    }
    // The large view has words beside it: a tool tip would cover the contact.
    if (const auto* view = qobject_cast<const ZoomView*>(&widget)) {
        return !view->accessibleDescription().isEmpty();
    }
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget()) {
        if (!at->toolTip().isEmpty()) {
            return true;
        }
    }
    return false;
}

std::string nameOf(const QWidget& widget) {
    std::string name = typeid(widget).name();
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget()) {
        if (!at->objectName().isEmpty()) {
            name += " in " + at->objectName().toStdString();
        }
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        name += " “" + button->text().toStdString() + "”";
    }
    return name;
}

int checkWidgets(const QWidget& top) {
    int count = 0;
    for (const QWidget* widget : top.findChildren<QWidget*>()) {
        if (!isPart(*widget) && (isInteractive(*widget) || isReading(*widget))) {
            ++count;
            EXPECT_TRUE(hasToolTip(*widget)) << nameOf(*widget);
        }
    }
    return count;
}

/// Qt gives an action without one its text.
QString textOf(const QAction& action) {
    QString text = action.text();
    text.remove(QLatin1Char('&'));
    text.remove(QStringLiteral("..."));
    return text;
}

int checkMenu(const QMenu& menu) {
    int count = 0;
    EXPECT_TRUE(menu.toolTipsVisible()) << menu.title().toStdString();
    for (const QAction* action : menu.actions()) {
        if (action->menu() != nullptr) {
            count += checkMenu(*action->menu());
        } else if (!action->isSeparator()) {
            ++count;
            EXPECT_TRUE(!action->statusTip().isEmpty() ||
                        (!action->toolTip().isEmpty() && action->toolTip() != textOf(*action)))
                << menu.title().toStdString() << " > " << action->text().toStdString();
        }
    }
    return count;
}

class ToolTips : public Window {};

TEST_F(ToolTips, EveryControlReadingPlotAndBannerHasOne) {
    openFlatScene();
    for (const PanelSwitch& part : window.layout().switches()) {
        part.setShown(true);
    }
    ASSERT_TRUE(runsFor(0.2));
    EXPECT_GT(checkWidgets(window), 60);
}

TEST_F(ToolTips, SoHasEveryEntryOfTheMenus) {
    openFlatScene();
    int count = 0;
    for (const QAction* menu : window.menuBar()->actions()) {
        count += checkMenu(*menu->menu());
    }
    EXPECT_GT(count, 40);
}

}  // namespace
}  // namespace asperity::test
