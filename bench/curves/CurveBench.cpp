// Reading, preparing and fitting a measured force curve beside nanite in one run, and a map of
// curves on two cores.
#include "bench/BenchFolder.h"
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "bench/CommandOutput.h"
#include "core/Error.h"
#include "core/ShareOut.h"
#include "core/identify/cycle/CycleIdentification.h"
#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/identify/SyntheticCurve.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr const char* kCurve = "fmt-jpk-fd_spot3-0192.jpk-force";
constexpr double kConeAngle = 30.0;  // half of it [degrees]
constexpr int kRepeats = 201;
constexpr int kQuickRepeats = 21;
constexpr double kCurveGoal = 5.0;  // [ms]
constexpr int kMapSide = 64;
constexpr int kQuickMapSide = 16;
constexpr double kMapGoal = 30.0;  // of the whole map [s]
constexpr int kMapCores = 2;
constexpr std::size_t kMapSamples = 1000;  // of a curve, both branches

double secondsSince(std::chrono::steady_clock::time_point begin) {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    return time.count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// @throw Error where nothing was identified
double modulusOf(const CurveIdentification& found) {
    const IdentifiedValue* const modulus = found.find("youngs_modulus_pa");
    if (modulus == nullptr) {
        throw Error("a curve of the measurement has no modulus");
    }
    return modulus->value;
}

/// How long a curve takes, and what comes out.
struct CurveTiming {
    double time = 0.0;     ///< median [s]
    double reading = 0.0;  ///< of it, the median [s]
    double modulus = 0.0;  ///< [Pa]
};

CurveTiming timeOurs(const std::filesystem::path& file, int repeats) {
    CycleFitOptions options;
    options.curve.tip =
        TipForm{.kind = TipKind::Cone, .angle = kConeAngle * std::numbers::pi / 180.0};
    CurveTiming timing;
    std::vector<double> times;
    std::vector<double> readings;
    for (int i = 0; i < repeats; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        const MeasuredForceCurve curve = readForceCurve(file);
        readings.push_back(secondsSince(begin));
        timing.modulus = modulusOf(identifyCurve(curve, options));
        times.push_back(secondsSince(begin));
    }
    timing.time = median(times);
    timing.reading = median(readings);
    return timing;
}

/// Returns none where nanite is not installed.
std::optional<CurveTiming> timeNanite(const std::filesystem::path& file) {
    const std::string line =
        firstLineOf("python3 " + quoted(ASPERITY_NANITE_SCRIPT) + " " + quoted(file) + " " +
                    std::to_string(kConeAngle) + " 2>/dev/null");
    char* rest = nullptr;
    const double time = std::strtod(line.c_str(), &rest);
    if (rest == line.c_str()) {
        return std::nullopt;
    }
    return CurveTiming{.time = 1e-9 * time, .modulus = std::strtod(rest, nullptr)};
}

void benchCurve(const BenchOptions& options, std::vector<BenchRow>& rows) {
    const auto file = std::filesystem::path(ASPERITY_MEASURED_CURVES) / kCurve;
    if (!std::filesystem::exists(file)) {
        std::printf("%s: not there, so no measured curve is fitted\n", file.c_str());
        return;
    }
    const CurveTiming ours = timeOurs(file, options.quick ? kQuickRepeats : kRepeats);
    const std::optional<CurveTiming> nanite = timeNanite(file);
    std::printf("%s, 4,000 points, cone: read %.3f ms, read and identified %.3f ms, E %.1f kPa\n",
                kCurve, 1e3 * ours.reading, 1e3 * ours.time, 1e-3 * ours.modulus);
    if (nanite) {
        std::printf("  nanite: %.1f ms, E %.1f kPa\n", 1e3 * nanite->time, 1e-3 * nanite->modulus);
    } else {
        std::printf("  nanite is not installed (pip install nanite)\n");
    }
    const std::string name = "measured curve, 4000 points: ";
    rows.push_back({.name = name + "read, prepare and fit",
                    .value = 1e3 * ours.time,
                    .unit = "ms",
                    .goal = kCurveGoal,
                    .kind = GoalKind::AtMost});
    rows.push_back({.name = name + "nanite over ours",
                    .value = nanite ? std::optional(nanite->time / ours.time) : std::nullopt,
                    .unit = "x",
                    .goal = 1.0});
}

/// Curves of an elastic sample whose modulus grows threefold over the map, with noise.
std::vector<MeasuredForceCurve> makeMap(int side, const test::SyntheticCurve& usual) {
    std::vector<MeasuredForceCurve> curves(static_cast<std::size_t>(side * side));
    shareOut(static_cast<int>(curves.size()), nullptr, [&](int i, const CancelCheck& /*check*/) {
        test::SyntheticCurve one = usual;
        one.reducedModulus *= std::pow(3.0, static_cast<double>(i) / (side * side));
        curves[static_cast<std::size_t>(i)] = one.curve(static_cast<unsigned>(i + 1));
    });
    return curves;
}

void benchMap(const BenchOptions& options, std::vector<BenchRow>& rows) {
    const int side = options.quick ? kQuickMapSide : kMapSide;
    const test::SyntheticCurve usual{.noise = 2e-11, .samples = kMapSamples / 2};
    const std::vector<MeasuredForceCurve> curves = makeMap(side, usual);
    CycleFitOptions fit;
    fit.curve.tip = usual.tip;
    std::vector<double> moduli(curves.size());
    const auto begin = std::chrono::steady_clock::now();
    shareOut(
        side * side, nullptr,
        [&](int i, const CancelCheck& /*check*/) {
            const auto index = static_cast<std::size_t>(i);
            moduli[index] = modulusOf(identifyCurve(curves[index], fit));
        },
        kMapCores);
    const double time = secondsSince(begin);
    std::printf("map of %d x %d curves of %zu points, %d cores: %.2f s, %.3f ms a curve and core, "
                "median E %.2f kPa\n",
                side, side, kMapSamples, kMapCores, time,
                1e3 * time * kMapCores / static_cast<double>(curves.size()), 1e-3 * median(moduli));
    rows.push_back({.name = "map of " + std::to_string(side) + "^2 curves of " +
                            std::to_string(kMapSamples) + " points: fit on " +
                            std::to_string(kMapCores) + " cores",
                    .value = time,
                    .unit = "s",
                    .goal = kMapGoal * (side * side) / (kMapSide * kMapSide),
                    .kind = GoalKind::AtMost});
}

int runBench(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("Fits of measured force curves, beside nanite");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    std::vector<BenchRow> rows;
    benchCurve(options, rows);
    benchMap(options, rows);
    giveRows(rows, options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
