#include "app/session/StartTimes.h"

#include "app/program/JsonText.h"
#include "app/session/LiveWindow.h"
#include "ui/view/ZoomView.h"

#include <QApplication>

#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <unistd.h>

namespace asperity {

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
    const ZoomView& view = live.window().view();
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
