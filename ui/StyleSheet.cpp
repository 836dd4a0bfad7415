#include "ui/StyleSheet.h"

#include <array>
#include <utility>

namespace asperity {

namespace {

const char* const kSheet = R"(
    QFrame[card="true"] { background: @paper; border: 1px solid @faint; border-radius: 6px; }
    QPushButton, QToolButton {
        background: @paper; border: 1px solid @faint; border-radius: 4px; padding: 3px 9px; }
    QPushButton:hover, QToolButton:hover { border-color: @accent; }
    QPushButton:pressed, QToolButton:pressed { background: @window; }
    QPushButton:checked, QToolButton:checked {
        background: @wash; border-color: @accent; color: @accent; }
    QPushButton:focus, QToolButton:focus { border-color: @accent; }
    QToolButton[compact="true"] { padding: 3px 4px; }
    QToolButton[heading="true"] {
        background: transparent; border: none; padding: 0; font-weight: bold; }
    QToolButton[heading="true"]:hover { color: @accent; }
    QPushButton#startPause {
        background: @accent; border-color: @accent; color: @onAccent; font-weight: bold; }
    QPushButton#startPause:hover { background: @pressed; }
    QMenuBar, QStatusBar { background: @window; }
    QMenu { background: @paper; border: 1px solid @faint; }
    QMenu::item { padding: 4px 24px 4px 16px; }
    QMenu::item:selected { background: @wash; color: @ink; }
    QToolTip { background: @paper; color: @ink; border: 1px solid @faint; padding: 3px; }
    QStatusBar::item { border: none; }
    QSplitter::handle { background: @window; }
    QSplitter::handle:hover { background: @faint; }
)";

}  // namespace

QString styleSheet(const ThemeColors& colors) {
    constexpr int kDarker = 115;  // [%]
    const std::array<std::pair<const char*, QColor>, 8> names{
        {{"@paper", colors.paper},
         {"@faint", colors.faint},
         {"@accent", colors.accent},
         {"@window", colors.window},
         {"@wash", colors.wash},
         {"@onAccent", colors.onAccent},
         {"@ink", colors.ink},
         {"@pressed", colors.accent.darker(kDarker)}}};
    QString sheet = QString::fromUtf8(kSheet);
    for (const auto& [name, color] : names) {
        sheet.replace(QString::fromUtf8(name), color.name());
    }
    return sheet;
}

}  // namespace asperity
