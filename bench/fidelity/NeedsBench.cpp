// Gain of leaving terms out: ticks of 200 random scenes with everything against ticks with what
// each scene requires, in turns; how far the force moves at positions that RequiredTerms did not
// look at; and the stated errors of fifteen scenes beside the true ones.

#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "core/FormattedText.h"
#include "core/fidelity/RequiredTerms.h"
#include "core/fidelity/SampledRuns.h"
#include "tests/core/fidelity/RandomScene.h"
#include "tests/core/fidelity/StatedErrors.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace asperity {
namespace {

constexpr int kScenes = 200;
constexpr int kQuickScenes = 20;
constexpr int kRounds = 7;

struct Gain {
    double tickRatio = 1.0;  ///< required over everything
    double moved = 0.0;      ///< at other positions, see forceShare()
    int leftOut = 0;         ///< terms of the force
    double fitTime = 0.0;    ///< of finding out what the scene requires [s]
};

int leftOutOf(const RequiredTerms& needs) {
    return static_cast<int>(std::ranges::count_if(needs.terms, [&](const TermNeed& need) {
        return !isOfSurface(need.term) && has(needs.full, need.term) &&
               !has(needs.model, need.term);
    }));
}

Gain gainOf(Scene& scene) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const RequiredTerms needs = fitModel(scene);
    const double fitTime = std::chrono::duration<double>(Clock::now() - start).count();
    setModel(scene, needs.full);
    const std::vector<ModelInputs> runs = test::runsElsewhere(scene);
    std::vector<double> whole;
    std::vector<double> required;
    Gain gain{.leftOut = leftOutOf(needs), .fitTime = fitTime};
    for (int round = 0; round < kRounds; ++round) {
        setModel(scene, needs.full);
        const ModelRun all = runModel(scene, runs);
        setModel(scene, needs.model);
        const ModelRun less = runModel(scene, runs);
        whole.push_back(quantile(all.times, 0.5));
        required.push_back(quantile(less.times, 0.5));
        gain.moved = forceShare(less.states, all.states);
    }
    gain.tickRatio = quantile(required, 0.5) / quantile(whole, 0.5);
    return gain;
}

void print(const std::vector<Gain>& gains, double tolerance, const BenchOptions& options) {
    std::vector<double> ratios;
    std::vector<double> moves;
    std::vector<double> fits;
    long within = 0;
    for (const Gain& gain : gains) {
        moves.push_back(gain.moved);
        fits.push_back(gain.fitTime);
        within += gain.moved <= tolerance ? 1 : 0;
        if (gain.leftOut > 0) {
            ratios.push_back(gain.tickRatio);
        }
    }
    const long faster = std::ranges::count_if(ratios, [](double ratio) { return ratio < 1.0; });
    std::printf("terms of the force left out in %zu of %zu scenes\n", ratios.size(), gains.size());
    std::printf("there a tick takes this share of one with everything: median %.2f, "
                "10 %% below %.2f, 90 %% below %.2f; faster in %ld\n",
                quantile(ratios, 0.5), quantile(ratios, 0.1), quantile(ratios, 0.9), faster);
    std::printf("finding out takes: median %.0f ms, 90 %% below %.0f ms\n",
                quantile(fits, 0.5) * 1e3, quantile(fits, 0.9) * 1e3);
    std::printf("elsewhere the force moves by at most the tolerance of %.2g %% in %ld "
                "scenes; median %.2g %%, 90 %% below %.2g %%, worst %.2g %%\n",
                tolerance * 100.0, within, quantile(moves, 0.5) * 100.0,
                quantile(moves, 0.9) * 100.0, quantile(moves, 1.0) * 100.0);
    giveRows({{.name = "finding out what a scene requires: median",
               .value = quantile(fits, 0.5) * 1e3,
               .unit = "ms",
               .goal = 50.0,
               .kind = GoalKind::AtMost}},
             options);
}

/// As the table in docs/tradeoff.md.
void printStatedErrors() {
    const auto text = [](double error, const QuantityErrors& errors) {
        return formatted("%.2g %% (%s)", error * 100.0, nameOf(errors.worstQuantity()));
    };
    std::printf("| scene | left out | stated error | true error | fit |\n|---|---|---|---|---|\n");
    for (const test::StatedErrorScene& each : test::statedErrorScenes()) {
        using Clock = std::chrono::steady_clock;
        Scene scene = buildScene(each.description);
        const auto start = Clock::now();
        const RequiredTerms needs = fitModel(scene);
        const double time = std::chrono::duration<double>(Clock::now() - start).count();
        std::string out;
        for (const TermNeed& need : needs.terms) {
            const bool isOut = !need.on && need.possible && !isOfSurface(need.term);
            out += isOut ? (out.empty() ? "" : ", ") + std::string(nameOf(need.term)) : "";
        }
        const QuantityErrors stated = needs.totalErrors();
        const QuantityErrors error = test::trueErrors(scene, needs);
        std::printf("| %s | %s | %s | %s | %.0f ms |\n", each.name.c_str(), out.c_str(),
                    text(needs.statedError(), stated).c_str(), text(error.worst(), error).c_str(),
                    time * 1e3);
    }
}

int run(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("What leaving terms out gains, and how long finding out takes");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    Random random(20261122);
    std::vector<Gain> gains;
    double tolerance = 0.0;
    for (int i = 0; i < (options.quick ? kQuickScenes : kScenes); ++i) {
        Scene scene = test::randomScene(random);
        tolerance = scene.description.tolerance;
        gains.push_back(gainOf(scene));
    }
    print(gains, tolerance, options);
    printStatedErrors();
    return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::run); }
