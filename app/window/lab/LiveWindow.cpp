#include "app/window/lab/LiveWindow.h"

#include "app/program/EndSignals.h"
#include "app/program/JsonText.h"
#include "app/window/export/ExportControl.h"
#include "app/window/lab/Features.h"
#include "app/window/scene/OpenControl.h"
#include "core/Error.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Display.h"

#include <QApplication>
#include <QCoreApplication>

#include <array>
#include <ctime>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace asperity {

namespace {

char programName[] = "asperity";  // NOLINT: Qt wants it writable

std::array<int, 2> ends{-1, -1};  // of a pipe: all that a signal handler may use

void note(int /*signal*/) {
    const char byte = 1;
    [[maybe_unused]] const ssize_t written = write(ends[1], &byte, 1);
}

int openPipe() { return pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0 ? ends[0] : -1; }

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
    , panels_(window_)
    , stage_(window_, panels_) {
    addFeatures(stage_);
    stage_.play();
}

void LiveWindow::remember(std::unique_ptr<QSettings> settings) {
    stage_.get<OpenControl>().remember(
        std::make_unique<QSettings>(settings->fileName(), settings->format()));
    stage_.get<ExportControl>().remember(
        std::make_unique<QSettings>(settings->fileName(), settings->format()));
    memory_.emplace(window_, panels_, std::move(settings));
}

int LiveWindow::exec() {
    const QuitOnSignal quitOnSignal;
    window_.show();
    return QApplication::exec();
}

QuitOnSignal::QuitOnSignal() : arrival_(openPipe(), QSocketNotifier::Read) {
    connect(&arrival_, &QSocketNotifier::activated, this, &QCoreApplication::quit);
    signals_.emplace(note);
}

QuitOnSignal::~QuitOnSignal() {
    signals_.reset();  // before what the handler writes to goes
    close(ends[0]);
    close(ends[1]);
}

namespace {

/// Since this process was started [s]; the kernel tells its start to a hundredth of a second.
double sinceStart() {
    std::ifstream file("/proc/self/stat");
    const std::string all(std::istreambuf_iterator<char>(file), {});
    std::istringstream fields(all.substr(all.rfind(')') + 1));  // the name before may hold blanks
    std::string skipped;
    constexpr int kBefore = 19;  // fields between the name and the start
    for (int i = 0; i < kBefore; ++i) {
        fields >> skipped;
    }
    double ticks = 0.0;
    fields >> ticks;
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) -
           ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

StartTimes::StartTimes(LiveWindow& live) : live_(live) {
    const ZoomView& view = live.panels().view();
    connect(&view, &ZoomView::frameRendered, this,
            [this, &view] { isDrawn_ = view.shown().has_value(); });
    connect(&view, &ZoomView::painted, this, &StartTimes::shown);
}

void StartTimes::shown() {
    if (window_ == 0.0) {
        window_ = sinceStart();
    }
    if (isDrawn_ && picture_ == 0.0) {
        picture_ = sinceStart();
        QApplication::quit();
    }
}

std::string StartTimes::json() const {
    return jsonText(nlohmann::ordered_json{{"window_s", window_}, {"first_picture_s", picture_}});
}

}  // namespace asperity
