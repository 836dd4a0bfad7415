// Growth of times with pixels, tip radius and roughness: slopes on two logarithmic axes.
#include "app/commands/VirtualDisplay.h"
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "bench/scaling/ScalingFigure.h"
#include "bench/scaling/ScalingMeasurement.h"
#include "bench/scaling/ScalingTable.h"

#include <CLI/CLI.hpp>
#include <string>

namespace asperity {

namespace {

ScalingEffort effortOf(const BenchOptions& options) {
    return options.quick ? ScalingEffort{.tiles = {1, 2, 4}, .steps = 4000} : ScalingEffort{};
}

int runBench(int argc, char** argv) {
    BenchOptions options;
    std::string figure;
    CLI::App app("How times grow with pixels, tip radius and roughness");
    app.add_option("--figure", figure, "file for the figure, PNG");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    const ScalingEffort effort = effortOf(options);
    std::vector<ScalingSweep> sweeps;
    for (const auto measure : {sweepPixels, sweepTipRadius, sweepRoughness}) {
        sweeps.push_back(measure(effort));
        printTable(sweeps.back());
    }
    if (!figure.empty()) {
        const OffscreenApplication qt;
        writeScalingFigure(figure, sweeps);
    }
    giveRows(scalingRows(sweeps), options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
