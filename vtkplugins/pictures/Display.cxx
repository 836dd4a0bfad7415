#include "vtkplugins/pictures/Display.h"

#include <X11/Xlib.h>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
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
    // NOLINTNEXTLINE(concurrency-mt-unsafe): changed at the start and at the end only
    const char* const name = std::getenv("DISPLAY");
    if (name == nullptr) {
        return false;
    }
    static std::mutex mutex;
    static std::optional<std::string> tried;
    static Display* display = nullptr;
    const std::scoped_lock lock(mutex);
    if (tried != name) {
        display = openDisplay();
        tried = name;
    }
    return display != nullptr;
}

}  // namespace asperity
