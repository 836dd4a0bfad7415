#include "app/commands/ProgressLine.h"

#include <cmath>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace asperity {

ProgressLine::ProgressLine(std::string work, std::chrono::seconds pause)
    : work_(std::move(work)), isTerminal_(isatty(STDERR_FILENO) == 1), pause_(pause) {}

ProgressLine::~ProgressLine() {
    if (isTerminal_) {
        std::cerr << "\r\033[K" << std::flush;
    }
}

void ProgressLine::report(double fraction) {
    const long percent = std::lround(100.0 * fraction);
    if (std::exchange(shown_, percent) == percent) {
        return;
    }
    if (isTerminal_) {
        std::cerr << '\r' << work_ << ' ' << percent << " %\033[K" << std::flush;
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - lastLine_ >= pause_) {
        lastLine_ = now;
        std::cerr << work_ << ' ' << percent << " %\n";
    }
}

LoadedScene loadSceneOnTerminal(const std::filesystem::path& input,
                                const SceneOverrides& overrides) {
    ProgressLine line("loading");
    LoadedScene loaded = loadScene(input, overrides, &line);
    reportTo(&line, 1.0);
    return loaded;
}

}  // namespace asperity
