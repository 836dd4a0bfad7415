#include "bench/scaling/ScalingMeasurement.h"

#include "bench/scaling/FitTimes.h"
#include "bench/surface/ForceChain.h"
#include "bench/surface/MethodRun.h"
#include "bench/surface/OurQuery.h"
#include "bench/surface/SearchWork.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/ScanMaps.h"

#include <deque>
#include <span>
#include <string>
#include <utility>

namespace asperity {

namespace {

constexpr int kPasses = 11;
constexpr double kNanosecond = 1e-9;  // [s]

/// Certified closest points of a tip that slides. @param surface outlives the task
MethodTask taskOf(const BSplineSurface& surface, const Slide& slide) {
    return {.work = {.name = "slide", .surface = &surface, .centers = slidingTip(surface, slide)},
            .method = ourMethod(surface, SearchEffort::Certified)};
}

ScalingCurve curveOf(const char* name, double maxSlope, std::span<const MethodTimes> slides,
                     double TimeSummary::*time) {
    ScalingCurve curve{.name = name, .maxSlope = maxSlope};
    for (const MethodTimes& slide : slides) {
        curve.times.push_back(slide.time.*time * kNanosecond);
    }
    return curve;
}

void addSlides(std::span<const MethodTask> tasks, double maxSlope, ScalingSweep& sweep) {
    const std::vector<MethodTimes> slides = timeTasks(tasks, kPasses);
    sweep.curves.push_back(
        curveOf("closest point, median", maxSlope, slides, &TimeSummary::median));
    sweep.curves.push_back(curveOf("closest point, p99", maxSlope, slides, &TimeSummary::p99));
    for (const MethodTimes& slide : slides) {
        sweep.queries += slide.queries;
        sweep.certified += slide.certified;
    }
}

}  // namespace

ScalingSweep sweepPixels(const ScalingEffort& effort) {
    constexpr double kMillion = 1e6;
    constexpr double kLinear = 1.1;  // with what caches lose on large maps
    constexpr double kFlat = 0.1;    // a factor of 1.7 from 512^2 to 8192^2 pixels
    const ScanMap tile = test::singlePrecision(pathMap());
    ScalingSweep sweep{.what = "map pixels", .unit = "million"};
    std::vector<ScanMap> maps;
    for (const int tiles : effort.tiles) {
        const ScanMap& map = maps.emplace_back(tiled(tile, tiles));
        sweep.works.push_back(static_cast<double>(map.heights.size()) / kMillion);
        sweep.labels.push_back(std::to_string(map.columns) + "²");
    }
    FitTimes fits = timeFits(maps);
    sweep.curves = {
        {.name = "surface (smoothing, fit, bounds)",
         .maxSlope = kLinear,
         .times = std::move(fits.surface)},
        {.name = "smoothing and fit alone", .maxSlope = kLinear, .times = std::move(fits.fit)},
        {.name = "closest point, force, decoupling, median", .maxSlope = kFlat}};
    std::deque<BSplineSurface> surfaces;
    std::vector<MethodTask> tasks;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const int middle = effort.tiles[i] / 2;
        surfaces.push_back(fitSurface(std::move(maps[i])));
        tasks.push_back(taskOf(surfaces.back(),
                               {.steps = effort.steps,
                                .corner = Vector2(middle * tile.sizeX(), middle * tile.sizeY())}));
        const ChainResult chain = timeChain(surfaces.back(), tasks.back().work.centers, kPasses);
        sweep.curves.back().times.push_back(chain.time.median * kNanosecond);
    }
    addSlides(tasks, kFlat, sweep);
    return sweep;
}

ScalingSweep sweepTipRadius(const ScalingEffort& effort) {
    constexpr int kTiles = 4;      // the largest tip stays away from every edge
    constexpr double kArea = 2.0;  // under the tip
    const HeightMap tile = pathMap();
    const BSplineSurface surface = fitSurface(tiled(tile, kTiles));
    ScalingSweep sweep{.what = "tip radius", .unit = "pixels"};
    std::vector<MethodTask> tasks;
    for (const double radius : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) {
        sweep.works.push_back(radius);
        tasks.push_back(taskOf(surface, {.steps = effort.steps,
                                         .corner = Vector2(tile.sizeX(), tile.sizeY()),
                                         .tipRadius = radius * tile.pitchX,
                                         .stepsPerTouch = 10}));
    }
    addSlides(tasks, kArea, sweep);
    return sweep;
}

ScalingSweep sweepRoughness(const ScalingEffort& effort) {
    constexpr double kNanometer = 1e-9;    // [m]
    constexpr double kProportional = 1.0;  // to the heights
    ScalingSweep sweep{.what = "rms roughness", .unit = "nm"};
    std::deque<BSplineSurface> surfaces;
    std::vector<MethodTask> tasks;
    for (const double rms : {1.0, 2.0, 5.0, 10.0}) {
        sweep.works.push_back(rms);
        surfaces.push_back(fitSurface(selfAffineGround(rms * kNanometer)));
        tasks.push_back(taskOf(surfaces.back(), {.steps = effort.steps}));
    }
    addSlides(tasks, kProportional, sweep);
    return sweep;
}

}  // namespace asperity
