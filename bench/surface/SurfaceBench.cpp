// Time and error of the closest point on a spline surface, beside other programs, in one run.
#include "bench/BenchMain.h"
#include "bench/surface/BenchReport.h"
#include "bench/surface/ForceChain.h"
#include "bench/surface/MapCopy.h"
#include "bench/surface/OurQuery.h"
#include "bench/surface/Peers.h"
#include "bench/surface/SearchTargets.h"
#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/leveling/Leveling.h"
#include "tools/samples/SampleScans.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <utility>

namespace asperity {

namespace {

constexpr std::size_t kSlideSteps = 20000;
constexpr std::size_t kRandomTips = 100000;
constexpr std::size_t kQuickPart = 10;
constexpr int kPasses = 5;

struct Options {
    std::string work = "all";
    std::vector<std::string> scans;  ///< of the random work, instead of its own
    std::size_t queries = 0;         ///< 0: as many as each work has by itself
    bool json = false;
    BenchOptions bench;

    [[nodiscard]] bool wants(const char* name) const { return work == "all" || work == name; }
    [[nodiscard]] std::size_t queriesOr(std::size_t usual) const {
        const std::size_t own = bench.quick ? usual / kQuickPart : usual;
        return queries == 0 ? own : queries;
    }
};

WorkResult runSlide(const std::string& name, const HeightMap& map, const Options& options) {
    const BSplineSurface surface = fitSurface(map);
    const SearchWork work{name, &surface,
                          slidingTip(surface, {.steps = options.queriesOr(kSlideSteps)})};
    const auto truth = referenceOf(work);
    std::vector<std::unique_ptr<SearchMethod>> methods;
    for (const SearchEffort effort :
         {SearchEffort::Certified, SearchEffort::Global, SearchEffort::Local}) {
        methods.push_back(ourMethod(surface, effort));
    }
    methods.push_back(warmNewtonMethod(surface));
    std::ranges::move(peerMethods(surface), std::back_inserter(methods));
    constexpr std::size_t kDoubted = 200;  // queries that are looked at again
    return {.name = name,
            .referenceDoubt =
                referenceDoubt(work, truth, std::max<std::size_t>(truth.size() / kDoubted, 1)),
            .methods = runMethods(work, truth, methods, kPasses)};
}

MethodResult oursOnSlide(const BSplineSurface& surface, std::size_t steps, const Vector2& corner) {
    const SearchWork work{"slide", &surface,
                          slidingTip(surface, {.steps = steps, .corner = corner})};
    const auto truth = referenceOf(work);
    std::vector<std::unique_ptr<SearchMethod>> methods;
    methods.push_back(ourMethod(surface, SearchEffort::Certified));
    return runMethods(work, truth, methods, kPasses).front();
}

SizeResult runSizes(const Options& options) {
    constexpr int kTimes = 8;
    constexpr int kTile = 4;  // away from every edge
    const std::size_t steps = options.queriesOr(kSlideSteps);
    const HeightMap map = pathMap();
    const HeightMap large = tiled(map, kTimes);
    return {.smallPixels = map.columns,
            .largePixels = large.columns,
            .onSmall = oursOnSlide(fitSurface(map), steps, Vector2::Zero()),
            .onLarge = oursOnSlide(fitSurface(large), steps,
                                   Vector2(kTile * map.sizeX(), kTile * map.sizeY()))};
}

ChainResult runChain(const Options& options) {
    const BSplineSurface surface = fitSurface(pathMap());
    const auto tips = slidingTip(surface, {.steps = options.queriesOr(kSlideSteps)});
    return timeChain(surface, tips, kPasses);
}

/// The scans of the random work: those asked for, or the samples and what measured ones are there.
std::vector<SampleScan> scansFor(const Options& options) {
    std::vector<std::string> files = options.scans;
    std::vector<SampleScan> scans;
    if (files.empty()) {
        std::ranges::copy_if(makeSampleScans(), std::back_inserter(scans), &SampleScan::isHeight);
        for (const char* name : {"nanoscope/cl_0deg_xcal_v9.70.spm", "nanoscope/di-3_v9.01.di",
                                 "nanoscope/veeco_v5.12.000"}) {
            const auto file = std::filesystem::path(ASPERITY_MEASURED_SCANS) / name;
            if (std::filesystem::exists(file)) {
                files.push_back(file.string());
            }
        }
    }
    for (const std::string& file : files) {
        const HeightMapFile content = readHeightMapFile(file);
        scans.push_back(
            {.fileName = std::filesystem::path(file).filename().string(),
             .map = leveled(heightChannel(content, file, "").map, {LevelingStep::Plane})});
    }
    return scans;
}

std::vector<RandomResult> runRandoms(const Options& options) {
    constexpr std::uint64_t kSeed = 20050913;
    std::vector<RandomResult> results;
    for (const SampleScan& scan : scansFor(options)) {
        const BSplineSurface surface = fitSurface(scan.map);
        const SearchWork work{scan.fileName, &surface,
                              randomTips(surface, options.queriesOr(kRandomTips), kSeed)};
        results.push_back(runRandom(work, kSeed));
    }
    return results;
}

BenchResults runAll(const Options& options) {
    BenchResults results{.missingPeers = missingPeers()};
    if (options.wants("path")) {
        results.works.push_back(runSlide("path", pathMap(), options));
    }
    if (options.wants("rough")) {
        results.works.push_back(runSlide("rough", roughMap(), options));
    }
    if (options.wants("concave")) {
        results.works.push_back(runSlide("concave", concaveMap(), options));
    }
    if (options.wants("random")) {
        results.random = runRandoms(options);
    }
    if (options.wants("size")) {
        results.size = runSizes(options);
    }
    if (options.wants("chain")) {
        results.chain = runChain(options);
    }
    results.copies = {timeCopy(512), timeCopy(4096)};
    return results;
}

int runBench(int argc, char** argv) {
    Options options;
    CLI::App app("Closest point on a spline surface: time and error, beside other programs");
    app.add_option("--work", options.work, "what to measure")
        ->check(CLI::IsMember({"all", "path", "rough", "concave", "random", "size", "chain"}))
        ->capture_default_str();
    app.add_option("--scan", options.scans, "scan for the random work, in place of its own")
        ->check(CLI::ExistingFile);
    app.add_option("--queries", options.queries, "queries of each work, in place of its own")
        ->check(CLI::PositiveNumber);
    app.add_flag("--json", options.json, "for programs");
    addBenchOptions(app, options.bench);
    CLI11_PARSE(app, argc, argv);
    const BenchResults results = runAll(options);
    if (options.json) {
        printJson(results);
    } else {
        printTables(results);
        giveRows(searchRows(results), options.bench);
    }
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
