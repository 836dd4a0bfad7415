#include "ui/window/WindowMemory.h"

#include "ui/panels/Card.h"
#include "ui/window/MainWindow.h"

#include <QGuiApplication>
#include <QScreen>

#include <utility>

namespace asperity {

namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kFolded = QStringLiteral("window/foldedPanels");

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
}

WindowMemory::~WindowMemory() {
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
