#include "app/commands/ProgressLine.h"

#include "core/FormattedText.h"

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

std::string ProgressLine::textOf(double fraction) {
    constexpr std::chrono::seconds kSoon(5);  // before this there is no pace to rely on
    std::string text = work_ + " " + std::to_string(std::lround(100.0 * fraction)) + " %";
    if (first_ < 0.0) {
        first_ = fraction;
    }
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin_;
    const double done = fraction - first_;
    if (since < kSoon || !(done > 0.0) || fraction >= 1.0) {
        return text;
    }
    return text + ", about " + durationText((1.0 - fraction) / done * since.count()) + " left";
}

void ProgressLine::report(double fraction) {
    const long percent = std::lround(100.0 * fraction);
    if (std::exchange(shown_, percent) == percent) {
        return;
    }
    const std::string text = textOf(fraction);
    if (isTerminal_) {
        std::cerr << '\r' << text << "\033[K" << std::flush;
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - lastLine_ >= pause_) {
        lastLine_ = now;
        std::cerr << text << '\n';
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
