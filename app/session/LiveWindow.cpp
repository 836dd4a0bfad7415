#include "app/session/LiveWindow.h"

#include "app/program/ToldError.h"
#include "app/session/QuitOnSignal.h"
#include "core/Error.h"
#include "ui/NumberText.h"
#include "ui/Theme.h"
#include "vtkplugins/pictures/Display.h"
#include "vtkplugins/pictures/DrawingMemory.h"

#include <exception>
#include <iostream>
#include <utility>

namespace asperity {

namespace {

char programName[] = "asperity";  // NOLINT: Qt wants it writable

}  // namespace

LiveWindow::Display::Display() {
    if (!haveDisplay()) {
        throw Error("no display to open the window on; `asperity explore` works without one");
    }
    requireDrawingMemory({});
    // As large as the desktop has its other programs, but never so that the window does not fit.
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication::setHighDpiScaleFactorRoundingPolicy(
        Qt::HighDpiScaleFactorRoundingPolicy::RoundPreferFloor);
}

LiveWindow::Application::Application(int& argumentCount, char** arguments)
    : QApplication(argumentCount, arguments) {
    keepDecimalPoint();
    applyTheme();  // before the first widget
}

bool LiveWindow::Application::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
        std::cerr << "asperity: " << messageOf(error) << '\n';
        exit(1);
        return true;
    }
}

LiveWindow::LiveWindow()
    : arguments_{programName, nullptr}
    , application_(argumentCount_, arguments_)
    , session_(window_) {}

void LiveWindow::remember(std::unique_ptr<QSettings> settings) {
    session_.files().remember(
        std::make_unique<QSettings>(settings->fileName(), settings->format()));
    session_.exports().remember(
        std::make_unique<QSettings>(settings->fileName(), settings->format()));
    memory_.emplace(window_, std::move(settings));
}

int LiveWindow::exec() {
    const QuitOnSignal quitOnSignal;
    window_.show();
    return QApplication::exec();
}

}  // namespace asperity
