#include "ui/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace asperity {

namespace {

QPalette lightPalette() {
    QPalette palette;
    palette.setColor(QPalette::Window, theme::kWindow);
    palette.setColor(QPalette::WindowText, theme::kInk);
    palette.setColor(QPalette::Base, theme::kPaper);
    palette.setColor(QPalette::AlternateBase, theme::kWindow);
    palette.setColor(QPalette::Text, theme::kInk);
    palette.setColor(QPalette::Button, theme::kPaper);
    palette.setColor(QPalette::ButtonText, theme::kInk);
    palette.setColor(QPalette::Highlight, theme::kAccent);
    palette.setColor(QPalette::HighlightedText, theme::kPaper);
    palette.setColor(QPalette::ToolTipBase, theme::kPaper);
    palette.setColor(QPalette::ToolTipText, theme::kInk);
    palette.setColor(QPalette::Disabled, QPalette::WindowText, theme::kMuted);
    palette.setColor(QPalette::Disabled, QPalette::Text, theme::kMuted);
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, theme::kMuted);
    return palette;
}

/// %1 faint, %2 accent, %3 ink, %4 window, %5 paper, %6 a wash of the accent, %7 accent, darker.
QString styleSheet() {
    const QString sheet = QStringLiteral(R"(
        QFrame[card="true"] { background: %5; border: 1px solid %1; border-radius: 6px; }
        QPushButton, QToolButton {
            background: %5; border: 1px solid %1; border-radius: 4px; padding: 3px 9px; }
        QPushButton:hover, QToolButton:hover { border-color: %2; }
        QPushButton:pressed, QToolButton:pressed { background: %4; }
        QPushButton:checked, QToolButton:checked { background: %6; border-color: %2; color: %2; }
        QPushButton:focus, QToolButton:focus { border-color: %2; }
        QToolButton[heading="true"] {
            background: transparent; border: none; padding: 0; font-weight: bold; }
        QToolButton[heading="true"]:hover { color: %2; }
        QPushButton#startPause {
            background: %2; border-color: %2; color: %5; font-weight: bold; }
        QPushButton#startPause:hover { background: %7; }
        QMenuBar, QStatusBar { background: %4; }
        QMenu { background: %5; border: 1px solid %1; }
        QMenu::item { padding: 4px 24px 4px 16px; }
        QMenu::item:selected { background: %6; color: %3; }
        QToolTip { background: %5; color: %3; border: 1px solid %1; padding: 3px; }
        QStatusBar::item { border: none; }
        QSplitter::handle { background: %4; }
        QSplitter::handle:hover { background: %1; }
    )");
    const auto name = [](QRgb color) { return QColor(color).name(); };
    return sheet.arg(name(theme::kFaint), name(theme::kAccent), name(theme::kInk),
                     name(theme::kWindow), name(theme::kPaper), QStringLiteral("#e3f0f8"),
                     QColor(theme::kAccent).darker(115).name());
}

}  // namespace

namespace theme {

QFont textFont(int pixelSize) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(pixelSize);
    return font;
}

QFont boldFont(int pixelSize) {
    QFont font = textFont(pixelSize);
    font.setBold(true);
    return font;
}

}  // namespace theme

void applyTheme(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(lightPalette());
    QApplication::setFont(theme::textFont());
    application.setStyleSheet(styleSheet());
}

}  // namespace asperity
