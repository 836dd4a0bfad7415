// The program as people use it: how soon it shows a scan, how long it explores a large one, and
// what its loop and its window reach. Each run is a process of its own, on a virtual display
// (xvfb-run).
#include "bench/BenchFolder.h"
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "bench/CommandOutput.h"
#include "bench/Hills.h"
#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

namespace asperity {

namespace {

constexpr int kPixels = 4096;

/// A screen, and how many of its pixels are one of the window's.
struct Screen {
    int width = 0;
    int height = 0;
    int scale = 1;
};

class ProgramBench {
public:
    explicit ProgramBench(const BenchOptions& options) : isQuick_(options.quick) {
        writeHeightMap(folder_.file("large.gsf"), hills<HeightMap>(kPixels), {});
    }

    [[nodiscard]] std::vector<BenchRow> rows() {
        addStart();
        addExplore();
        addLoop();
        addWindow();
        return rows_;
    }

private:
    void addAtMost(const std::string& name, double value, const char* unit, double goal) {
        rows_.push_back(
            {.name = name, .value = value, .unit = unit, .goal = goal, .kind = GoalKind::AtMost});
    }

    /// Nothing of the user's settings and sessions takes part.
    [[nodiscard]] std::string program(const std::string& arguments) const {
        const std::string home = quoted(folder_.file("home"));
        return "env HOME=" + home + " XDG_CONFIG_HOME=" + home + " XDG_DATA_HOME=" + home + " " +
               quoted(ASPERITY_PROGRAM) + " " + arguments;
    }

    [[nodiscard]] std::string inWindow(const Screen& screen, const std::string& arguments) const {
        return "env QT_SCALE_FACTOR=" + std::to_string(screen.scale) +
               " xvfb-run -a -s '-screen 0 " + std::to_string(screen.width) + "x" +
               std::to_string(screen.height) + "x24 -noreset' " + program(arguments);
    }

    static nlohmann::json answerOf(const std::string& command) {
        const auto answer = nlohmann::json::parse(outputOf(command), nullptr, false);
        if (answer.is_discarded()) {
            throw Error("no answer from: " + command);
        }
        return answer;
    }

    /// Median over a few starts [s].
    [[nodiscard]] double start(const std::string& input) const {
        std::vector<double> times;
        for (int i = 0; i < (isQuick_ ? 3 : 7); ++i) {
            const auto answer = answerOf(inWindow({1280, 800}, input + " --time-start"));
            times.push_back(answer.at("first_picture_s").get<double>());
        }
        std::ranges::sort(times);
        return times[times.size() / 2];
    }

    void addStart() {
        addAtMost("start of the program: first 3-D picture", start(""), "s", 0.8);
        addAtMost("a 4096^2 scan opened in the window: first 3-D picture",
                  start(quoted(folder_.file("large.gsf"))), "s", 2.0);
    }

    void addExplore() {
        const std::string command = program("explore " + quoted(folder_.file("large.gsf")) +
                                            " --duration 0.2 --force "
                                            "--out " +
                                            quoted(folder_.file("run")) + " >" +
                                            quoted(folder_.file("log")) + " 2>&1 && echo done");
        double best = std::numeric_limits<double>::infinity();
        for (int i = 0; i < (isQuick_ ? 1 : 3); ++i) {
            const auto begin = std::chrono::steady_clock::now();
            if (firstLineOf(command) != "done") {
                throw Error("no answer from: " + command);
            }
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
            best = std::min(best, taken.count());
        }
        addAtMost("explore a 4096^2 scan for 0.2 s", best, "s", 1.5);
    }

    [[nodiscard]] std::string loopArguments(int usual) const {
        return "loop --json --duration " + std::to_string(isQuick_ ? 6 : usual);
    }

    void addTickTimes(const nlohmann::json& loop, const char* what, double median, double p99) {
        const nlohmann::json& times = loop.at("tick_time");
        const std::string name = std::string("tick in the live loop, ") + what + ": ";
        addAtMost(name + "median", 1e6 * times.at("p50_s").get<double>(), "us", median);
        addAtMost(name + "p99", 1e6 * times.at("p99_s").get<double>(), "us", p99);
    }

    void addLoop() {
        const auto loop = answerOf(program(loopArguments(60)));
        addAtMost("loop: median p99 lateness over that of a bare loop",
                  loop.at("median_block_p99_lateness_ratio").get<double>(), "x", 1.2);
        addTickTimes(loop, "no window", 6.0, 15.0);
    }

    void addFrames(const nlohmann::json& loop, const std::string& screen, double goal) {
        rows_.push_back({.name = "window on " + screen + ", everything open",
                         .value = loop.at("frames_per_second").at("zoom").get<double>(),
                         .unit = "frames/s",
                         .goal = goal});
    }

    void addWindow() {
        const auto usual = answerOf(inWindow({1920, 1080}, loopArguments(20) + " --window"));
        addTickTimes(usual, "window drawing", 10.0, 25.0);
        addFrames(usual, "1920 x 1080", 40.0);
        const auto fine = answerOf(inWindow({3840, 2160, 2}, loopArguments(20) + " --window"));
        addFrames(fine, "3840 x 2160 at scale 2", 25.0);
    }

    bool isQuick_;
    BenchFolder folder_;
    std::vector<BenchRow> rows_;
};

int runBench(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("The program as people use it: start, opening, exploring, loop and window");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    giveRows(ProgramBench(options).rows(), options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
