#include "vtkplugins/pictures/Display.h"

#include <X11/Xlib.h>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace asperity {

namespace {

/// Tries for about a second: a server that is starting anew answers after a moment.
Display* openDisplay() {
    constexpr int kAttempts = 10;
    constexpr std::chrono::milliseconds kPause(100);
    Display* display = nullptr;
    for (int attempt = 0; attempt < kAttempts && display == nullptr; ++attempt) {
        if (attempt > 0) {
            std::this_thread::sleep_for(kPause);
        }
        display = XOpenDisplay(nullptr);
    }
    return display;
}

}  // namespace

bool haveDisplay() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing changes the environment after the start
    if (std::getenv("DISPLAY") == nullptr) {
        return false;
    }
    static Display* const display = openDisplay();
    return display != nullptr;
}

}  // namespace asperity
