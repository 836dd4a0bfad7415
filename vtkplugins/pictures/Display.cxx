#include "vtkplugins/pictures/Display.h"

#include "core/Error.h"

#include <vtkLogger.h>
#include <vtkObject.h>

#include <X11/Xlib.h>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <sys/mman.h>
#include <thread>

namespace asperity {

namespace {

/// Tries for about a second: a server that is starting again answers after a moment.
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

constexpr std::size_t kMebibyte = std::size_t{1} << 20U;

/// Returns what Mesa's software driver takes for itself, once: its code, what it compiles, and a
/// heap and a stack for each of its threads. Measured with Mesa 22.3 as growth of the address space
/// over a first picture of 3200 x 2000 pixels: 1109 MiB on two cores, pictureMemory() in it.
std::size_t driverMemory() {
    constexpr std::size_t kCode = 400 * kMebibyte;
    constexpr std::size_t kPerThread = 72 * kMebibyte;
    constexpr unsigned kDrawingThreads = 32;  // Mesa starts no more
    constexpr unsigned kOtherThreads = 3;
    const unsigned drawing = std::clamp(std::thread::hardware_concurrency(), 1U, kDrawingThreads);
    return kCode + kPerThread * (drawing + kOtherThreads);
}

/// Colors and depths of all layers, and what is read back of them. Measured: 56 bytes a pixel.
std::size_t pictureMemory(PictureSize drawn) {
    constexpr std::size_t kPerPixel = 60;
    return kPerPixel * static_cast<std::size_t>(drawn.width) *
           static_cast<std::size_t>(drawn.height);
}

/// Returns whether the system would give so much more.
bool isGranted(std::size_t bytes) {
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) {
        return false;
    }
    munmap(memory, bytes);
    return true;
}

/// Returns what there is without swapping, as Linux estimates it; all, where it does not say.
std::size_t availableMemory() {
    std::ifstream file("/proc/meminfo");
    for (std::string word; file >> word;) {
        std::size_t kibibytes = 0;
        if (word == "MemAvailable:" && file >> kibibytes) {
            return 1024 * kibibytes;
        }
    }
    return std::numeric_limits<std::size_t>::max();
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

void silenceVtk() {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkObject::GlobalWarningDisplayOff();
}

void requireDrawingMemory(PictureSize drawn) {
    static bool driverHasItsOwn = false;  // all drawing is done by one thread
    const std::size_t needed = pictureMemory(drawn) + (driverHasItsOwn ? 0 : driverMemory());
    if (!isGranted(needed)) {
        throw Error("Not enough memory to draw: OpenGL needs " +
                    std::to_string(needed / kMebibyte) +
                    " MiB more than the system grants (ulimit -v).");
    }
    if (const std::size_t available = availableMemory(); pictureMemory(drawn) > available) {
        throw Error("Not enough memory to draw: OpenGL needs " +
                    std::to_string(pictureMemory(drawn) / kMebibyte) + " MiB, and " +
                    std::to_string(available / kMebibyte) +
                    " MiB are available; draw fewer pixels.");
    }
    driverHasItsOwn = true;
}

}  // namespace asperity
