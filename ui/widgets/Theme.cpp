#include "ui/widgets/Theme.h"

#include "ui/widgets/LabStyle.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QLabel>
#include <QPalette>
#include <QScreen>
#include <QToolTip>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

ThemeColors forQt(const Palette& colors) {
    return {.paper = toQColor(colors.paper),
            .window = toQColor(colors.window),
            .backdrop = toQColor(colors.backdrop),
            .ink = toQColor(colors.ink),
            .muted = toQColor(colors.muted),
            .faint = toQColor(colors.faint),
            .accent = toQColor(colors.accent),
            .wash = toQColor(colors.wash),
            .onAccent = toQColor(colors.onAccent),
            .fault = toQColor(colors.fault),
            .caution = toQColor(colors.caution),
            .refused = toQColor(colors.refused),
            .side = toQColor(colors.side),
            .tip = toQColor(colors.tip),
            .tipBody = toQColor(colors.tipBody),
            .lever = toQColor(colors.lever),
            .force = toQColor(colors.force),
            .marker = toQColor(colors.marker),
            .path = toQColor(colors.path),
            .zoom = toQColor(colors.zoom),
            .guide = toQColor(colors.guide),
            .target = toQColor(colors.target),
            .commanded = toQColor(colors.commanded),
            .trueTip = toQColor(colors.trueTip),
            .blue = toQColor(colors.blue),
            .orange = toQColor(colors.orange),
            .green = toQColor(colors.green),
            .purple = toQColor(colors.purple),
            .sky = toQColor(colors.sky),
            .yellow = toQColor(colors.yellow),
            .gray = toQColor(colors.gray)};
}

/// What there is once in a program, as its QApplication.
struct Theme {
    ThemeChoice choice = ThemeChoice::Desktop;
    bool desktopIsDark = false;
    bool isDark = false;
    ThemeColors colors = forQt(kLightPalette);
    ThemeChange change;
};

Theme& theTheme() {
    static Theme theme;
    return theme;
}

QPalette qtPalette(const ThemeColors& colors) {
    QPalette palette(colors.window);  // with its shades
    const auto set = [&palette](QPalette::ColorRole role, const QColor& color) {
        palette.setColor(role, color);
    };
    set(QPalette::Window, colors.window);
    set(QPalette::WindowText, colors.ink);
    set(QPalette::Base, colors.paper);
    set(QPalette::AlternateBase, colors.window);
    set(QPalette::Text, colors.ink);
    set(QPalette::BrightText, colors.ink);
    set(QPalette::PlaceholderText, colors.muted);
    set(QPalette::Button, colors.paper);
    set(QPalette::ButtonText, colors.ink);
    set(QPalette::Highlight, colors.accent);
    set(QPalette::HighlightedText, colors.onAccent);
    set(QPalette::Link, colors.accent);
    set(QPalette::LinkVisited, colors.accent);
    set(QPalette::ToolTipBase, colors.paper);
    set(QPalette::ToolTipText, colors.ink);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, colors.muted);
    }
    palette.setColor(QPalette::Disabled, QPalette::Base, colors.window);
    return palette;
}

/// A bare display tells its size in millimeters, of which follow 100 dots an inch where 96 are
/// meant: near the usual steps of a desktop letters are as large as at the step.
double snapped(double points) {
    constexpr double kStep = 12.0;  // [dots an inch]
    const QScreen* screen = QGuiApplication::primaryScreen();
    const double dots = screen != nullptr ? screen->logicalDotsPerInchY() : 0.0;
    const double step = kStep * std::round(dots / kStep);
    return step > 0.0 ? points * step / dots : points;
}

bool isDarkChosen(const Theme& theme) {
    return theme.choice == ThemeChoice::Dark ||
           (theme.choice == ThemeChoice::Desktop && theme.desktopIsDark);
}

/// A menu is a card, and what is chosen in it has a soft color.
QPalette menuPalette(const ThemeColors& colors) {
    QPalette palette = qtPalette(colors);
    palette.setColor(QPalette::Window, colors.paper);
    palette.setColor(QPalette::Highlight, colors.wash);
    palette.setColor(QPalette::HighlightedText, colors.ink);
    return palette;
}

void show() {
    Theme& theme = theTheme();
    theme.isDark = isDarkChosen(theme);
    theme.colors = forQt(theme::palette());
    QApplication::setPalette(qtPalette(theme.colors));
    QApplication::setPalette(menuPalette(theme.colors), "QMenu");
    QToolTip::setPalette(QApplication::palette());
    Q_EMIT theme.change.happened();
}

}  // namespace

QColor toQColor(const Color& color) { return {color.red, color.green, color.blue}; }

namespace theme {

const ThemeColors& colors() { return theTheme().colors; }

const Palette& palette() { return isDark() ? kDarkPalette : kLightPalette; }

bool isDark() { return theTheme().isDark; }

ThemeChoice choice() { return theTheme().choice; }

void choose(ThemeChoice choice) {
    Theme& theme = theTheme();
    theme.choice = choice;
    if (theme.isDark != isDarkChosen(theme)) {
        show();
    }
}

LightColors::LightColors() : wasDark_(isDark()) {
    if (wasDark_) {
        theTheme().isDark = false;
        theTheme().colors = forQt(kLightPalette);
    }
}

LightColors::~LightColors() {
    if (wasDark_) {
        theTheme().isDark = true;
        theTheme().colors = forQt(kDarkPalette);
    }
}

void follow(QObject* owner, const std::function<void()>& show) {
    show();
    QObject::connect(&theTheme().change, &ThemeChange::happened, owner, show);
}

void colorText(QLabel& label, QColor ThemeColors::*color) {
    follow(&label, [&label, color] {
        QPalette palette = label.palette();
        palette.setColor(QPalette::WindowText, colors().*color);
        label.setPalette(palette);
    });
}

QFont textFont(double points) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPointSizeF(snapped(points));
    return font;
}

QFont boldFont(double points) {
    QFont font = textFont(points);
    font.setBold(true);
    return font;
}

int scaled(int pixels) {
    constexpr double kUsualHeight = 14.0;  // of kTextSize at 96 dots an inch [px]
    const double factor = QFontMetricsF(textFont()).height() / kUsualHeight;
    return static_cast<int>(std::lround(pixels * std::max(1.0, factor)));
}

}  // namespace theme

void applyTheme() {
    const QPalette desktop = QApplication::palette();
    theTheme().desktopIsDark = desktop.color(QPalette::Window).lightness() <
                               desktop.color(QPalette::WindowText).lightness();
    QApplication::setStyle(new LabStyle);
    QApplication::setFont(theme::textFont());
    show();
}

}  // namespace asperity
