#include "ui/window/WindowMemory.h"

#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/window/MainWindow.h"
#include "ui/window/Maximizer.h"
#include "ui/window/PageTabs.h"
#include "ui/window/ViewMemory.h"
#include "ui/window/WindowLayout.h"

#include <QGuiApplication>
#include <QScreen>
#include <QSplitter>
#include <QVariantList>

#include <array>
#include <utility>

namespace asperity {

namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kFolded = QStringLiteral("window/foldedPanels");
const QString kShown = QStringLiteral("window/shown/");
const QString kSplitter = QStringLiteral("window/splitter/");
const QString kTheme = QStringLiteral("window/theme");
const QString kOnTop = QStringLiteral("window/onTop/");

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
    const QStringList folded = settings_->value(kFolded).toStringList();
    for (Card* card : window_.cards()) {
        card->setFolded(folded.contains(card->title()));
    }
    restoreViews(window_, *settings_);  // first: which of them share the room
    restoreLayout();
    restoreTheme(*settings_);
}

void WindowMemory::restoreLayout() {
    WindowLayout& layout = window_.layout();
    for (const PanelSwitch& part : layout.switches()) {
        part.setShown(settings_->value(kShown + part.key, part.shownAtFirst).toBool());
    }
    for (QSplitter* splitter : layout.splitters()) {
        // Of as many panels as there are now.
        const QVariantList kept = settings_->value(kSplitter + splitter->objectName()).toList();
        if (kept.size() == 2 && kept.front().toInt() == splitter->count()) {
            splitter->restoreState(kept.back().toByteArray());
        }
    }
    for (PageTabs* pages : {&layout.tools(), &layout.sidePages()}) {
        pages->putOnTop(settings_->value(kOnTop + pages->objectName()).toString());
    }
}

void WindowMemory::keepLayout() {
    WindowLayout& layout = window_.layout();
    layout.maximizer().restore();
    for (const PanelSwitch& part : layout.switches()) {
        settings_->setValue(kShown + part.key, part.isShown());
    }
    for (const QSplitter* splitter : layout.splitters()) {
        settings_->setValue(kSplitter + splitter->objectName(),
                            QVariantList{splitter->count(), splitter->saveState()});
    }
    for (const PageTabs* pages : {&layout.tools(), &layout.sidePages()}) {
        settings_->setValue(kOnTop + pages->objectName(), pages->pageOnTop());
    }
}

WindowMemory::~WindowMemory() {
    keepLayout();
    keepTheme(*settings_);
    saveViews(window_, *settings_);
    QStringList folded;
    for (const Card* card : window_.cards()) {
        if (card->isFolded()) {
            folded << card->title();
        }
    }
    settings_->setValue(kGeometry, window_.saveGeometry());
    settings_->setValue(kFolded, folded);
}

std::unique_ptr<QSettings> userSettings() {
    return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                       QStringLiteral("Asperity"), QStringLiteral("asperity"));
}

}  // namespace asperity
