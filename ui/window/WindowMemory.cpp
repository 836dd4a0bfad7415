#include "ui/window/WindowMemory.h"

#include "ui/Theme.h"
#include "ui/window/LayoutMemory.h"
#include "ui/window/MainWindow.h"
#include "ui/window/Maximizer.h"
#include "ui/window/ViewMemory.h"
#include "ui/window/WindowLayout.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QGuiApplication>
#include <QScreen>

#include <array>
#include <utility>

namespace asperity {

namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kStart = QStringLiteral("session/startWithLast");
const QString kCompact = QStringLiteral("recordings/compact");
const QString kTheme = QStringLiteral("window/theme");

/// A screen that has become smaller than the window, or has gone, must not hide parts of it.
void bringOnScreen(QWidget& window) {
    const QRect place = window.geometry();
    const QScreen* screen = QGuiApplication::screenAt(place.center());
    const QRect available =
        (screen != nullptr ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    if (!available.contains(place)) {
        window.resize(place.size().boundedTo(available.size()));
        const QRect smaller = window.geometry();
        window.move(
            qBound(available.left(), smaller.left(), available.right() - smaller.width() + 1),
            qBound(available.top(), smaller.top(), available.bottom() - smaller.height() + 1));
    }
}

const std::array<std::pair<ThemeChoice, QString>, 3> kThemes{
    {{ThemeChoice::Desktop, QStringLiteral("desktop")},
     {ThemeChoice::Light, QStringLiteral("light")},
     {ThemeChoice::Dark, QStringLiteral("dark")}}};

void restoreTheme(const QSettings& settings) {
    const QString kept = settings.value(kTheme).toString();
    for (const auto& [choice, name] : kThemes) {
        if (name == kept) {
            theme::choose(choice);
        }
    }
}

void keepTheme(QSettings& settings) {
    for (const auto& [choice, name] : kThemes) {
        if (choice == theme::choice()) {
            settings.setValue(kTheme, name);
        }
    }
}

}  // namespace

WindowMemory::WindowMemory(MainWindow& window, std::unique_ptr<QSettings> settings)
    : window_(window), settings_(std::move(settings)) {
    if (window_.restoreGeometry(settings_->value(kGeometry).toByteArray()) &&
        !window_.isMaximized() && !window_.isFullScreen()) {
        bringOnScreen(window_);
    }
    QVariantMap kept;
    for (const QString& key : settings_->allKeys()) {
        kept.insert(key, settings_->value(key));
    }
    restoreViews(window_, kept);  // first: which of them share the room
    restoreLayout(window_, kept);
    restoreTheme(*settings_);
    window_.menus().startWithSession->setChecked(settings_->value(kStart, true).toBool());
    window_.menus().compactRecordings->setChecked(settings_->value(kCompact, false).toBool());
}

WindowMemory::~WindowMemory() {
    window_.layout().maximizer().restore();
    QVariantMap kept;
    keepLayout(window_, kept);
    keepViews(window_, kept);
    for (auto value = kept.cbegin(); value != kept.cend(); ++value) {
        settings_->setValue(value.key(), value.value());
    }
    keepTheme(*settings_);
    settings_->setValue(kStart, window_.menus().startWithSession->isChecked());
    settings_->setValue(kCompact, window_.menus().compactRecordings->isChecked());
    settings_->setValue(kGeometry, window_.saveGeometry());
}

std::unique_ptr<QSettings> userSettings() {
    return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                       QStringLiteral("Asperity"), QStringLiteral("asperity"));
}

}  // namespace asperity
