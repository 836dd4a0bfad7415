#include "app/window/session/WindowMemory.h"

#include "app/window/WindowSection.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/ViewMemory.h"
#include "core/Error.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WindowLayout.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QGuiApplication>
#include <QScreen>

#include <array>
#include <utility>

namespace asperity {

namespace {

constexpr int kSettingsPeriod = 500;  // between two looks at what has changed [ms]
const QString kGeometry = QStringLiteral("window/geometry");
const QString kTheme = QStringLiteral("window/theme");

/// A screen that has become smaller than the window, or has gone, must not hide parts of it.
void bringOnScreen(QWidget& window) {
    const QRect geometry = window.geometry();
    const QScreen* screen = QGuiApplication::screenAt(geometry.center());
    const QRect available =
        (screen != nullptr ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    if (!available.contains(geometry)) {
        window.resize(geometry.size().boundedTo(available.size()));
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

void keepTheme(QVariantMap& kept) {
    for (const auto& [choice, name] : kThemes) {
        if (choice == theme::choice()) {
            kept.insert(kTheme, name);
        }
    }
}

/// Writes into the settings that a file holds. It runs in a thread of its own.
LatestWriter<QVariantMap>::Write writerTo(const QSettings& settings) {
    return [file = settings.fileName(), format = settings.format()](const QVariantMap& kept) {
        QSettings written(file, format);
        for (auto value = kept.cbegin(); value != kept.cend(); ++value) {
            written.setValue(value.key(), value.value());
        }
        written.sync();
        if (written.status() != QSettings::NoError) {
            throw Error(file.toStdString() + ": the settings cannot be written");
        }
    };
}

}  // namespace

WindowMemory::WindowMemory(MainWindow& window, LivePanels& live,
                           std::unique_ptr<QSettings> settings)
    : window_(window), live_(live), writer_(writerTo(*settings)) {
    if (window_.restoreGeometry(settings->value(kGeometry).toByteArray()) &&
        !window_.isMaximized() && !window_.isFullScreen()) {
        bringOnScreen(window_);
    }
    QVariantMap kept;
    for (const QString& key : settings->allKeys()) {
        kept.insert(key, settings->value(key));
    }
    kept = withCurrentNames(kept);
    restoreViews(live_, kept);  // first: which of them share the room
    window_.restore(kept);
    restoreTheme(*settings);
    restoreFolders(kept);
    for (const auto& [key, entry] : window_.menus().kept()) {
        entry->setChecked(settings->value(key, entry->isChecked()).toBool());
    }
    kept_ = present();
    QObject::connect(&due_, &QTimer::timeout, &due_, [this] { keep(); });
    due_.start(kSettingsPeriod);
}

WindowMemory::~WindowMemory() {
    window_.layout().maximizer().restore();
    keep();
}

QVariantMap WindowMemory::present() const {
    QVariantMap kept;
    window_.keep(kept);
    keepViews(live_, kept);
    keepTheme(kept);
    keepFolders(kept);
    for (const auto& [key, entry] : window_.menus().kept()) {
        kept.insert(key, entry->isChecked());
    }
    kept.insert(kGeometry, window_.saveGeometry());
    return kept;
}

void WindowMemory::keep() {
    if (live_.isFixed()) {
        return;  // what it shows is not the user's choice
    }
    QVariantMap now = present();
    if (now != kept_) {
        kept_ = now;
        writer_.write(std::move(now));
    }
}

std::unique_ptr<QSettings> userSettings() {
    return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                       QStringLiteral("Asperity"), QStringLiteral("asperity"));
}

}  // namespace asperity
