#include "tools/samples/SampleScans.h"

#include "core/Units.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>
#include <numbers>

namespace asperity {

namespace {

constexpr int kPixels = 256;

ScanSize square(double side) {
    return {.columns = kPixels, .rows = kPixels, .sizeX = side, .sizeY = side};
}

void add(HeightMap& map, const HeightMap& other) {
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.heights[i] += other.heights[i];
    }
}

/// Whole periods in the scan, and hills that the 15 nm tip follows everywhere.
HeightMap eggBox() {
    return sampledMap(square(400.0_nm),
                      EggBox{.amplitude = 5.0_nm, .periodX = 100.0_nm, .periodY = 100.0_nm});
}

/// Flanks of about 45 degrees, with corners that a spline can follow without ringing.
HeightMap grating() {
    constexpr double kCornerRounding = 1.5;  // [pixel]
    const TrapezoidGrating shape{
        .pitch = 200.0_nm, .depth = 30.0_nm, .topWidth = 70.0_nm, .flankWidth = 30.0_nm};
    return smoothed(sampledMap(square(600.0_nm), shape), kCornerRounding);
}

constexpr double kRimRounding = 1.5;  // of particles [pixel]

/// Gold nanoparticles as a 10 nm tip would have scanned them.
HeightMap particlesAlone() {
    const ScanSize size = square(400.0_nm);
    return sampledMap(size, Nanoparticles({.count = 15,
                                           .medianRadius = 14.0_nm,
                                           .spread = 0.35,
                                           .smallest = 8.0_nm,
                                           .largest = 25.0_nm,
                                           .scanTipRadius = 10.0_nm,
                                           .clearance = 12.0_nm,
                                           .seed = 5},
                                          size));
}

/// Where the particles stand: 1, and 0 on the ground between them.
HeightMap particleMask() {
    HeightMap map = particlesAlone();
    for (double& value : map.heights) {
        value = value > 0.0 ? 1.0 : 0.0;
    }
    map = smoothed(map, kRimRounding);
    for (double& value : map.heights) {
        value = std::clamp(value, 0.0, 1.0);
    }
    return map;
}

/// The particles on softly rolling ground.
HeightMap particles() {
    HeightMap map = smoothed(particlesAlone(), kRimRounding);
    const ScanSize size = square(400.0_nm);
    add(map, selfAffineMap(size, {.rms = 1.6_nm,
                                  .hurst = 0.9,
                                  .longestWave = 400.0_nm,
                                  .rollOffWave = 200.0_nm,
                                  .shortestWave = 25.0_nm,
                                  .seed = 11}));
    return map;
}

HeightMap selfAffine() {
    return selfAffineMap(square(1.0_um), {.rms = 6.0_nm,
                                          .hurst = 0.8,
                                          .longestWave = 1.0_um,
                                          .rollOffWave = 300.0_nm,
                                          .shortestWave = 20.0_nm,
                                          .seed = 3});
}

/// Monatomic steps of Au(111) with 15 pm of noise, no finer than a spline can follow.
HeightMap steps() {
    const ScanSize size = square(400.0_nm);
    HeightMap map = sampledMap(size, AtomicSteps({.stepHeight = 0.235_nm,
                                                  .terraceWidth = 60.0_nm,
                                                  .edgeWidth = 1.5_nm,
                                                  .jitter = 6.0_nm,
                                                  .angle = std::numbers::pi / 9.0,
                                                  .seed = 7},
                                                 size));
    add(map, selfAffineMap(size, {.rms = 15.0_pm,
                                  .hurst = 0.5,
                                  .longestWave = 100.0_nm,
                                  .rollOffWave = 20.0_nm,
                                  .shortestWave = 6.5_nm,
                                  .seed = 8}));
    return map;
}

HeightMap spherulite() {
    constexpr double kSoftening = 1.0;  // [pixel]
    const ScanSize size = square(2.0_um);
    return smoothed(sampledMap(size, Spherulites({.nuclei = 5,
                                                  .growthHeadStart = 250.0_nm,
                                                  .domeHeight = 60.0_nm,
                                                  .domeRadius = 900.0_nm,
                                                  .bandHeight = 7.0_nm,
                                                  .bandPeriod = 160.0_nm,
                                                  .bandWaviness = 0.5,
                                                  .bandLobes = 5,
                                                  .fibrilHeight = 3.0_nm,
                                                  .fibrilLength = 220.0_nm,
                                                  .fibrils = 72,
                                                  .grooveDepth = 12.0_nm,
                                                  .grooveWidth = 30.0_nm,
                                                  .seed = 21},
                                                 size)),
                    kSoftening);
}

}  // namespace

std::vector<SampleScan> makeSampleScans() {
    return {
        {"egg_box.gsf", "Egg box, 10 nm high, period 100 nm", eggBox()},
        {"grating.gsf", "Trapezoid grating, pitch 200 nm, depth 30 nm", grating()},
        {"particles.gsf", "Nanoparticles of 8-25 nm radius on rolling ground", particles()},
        {"particle_mask.gsf", "Where the nanoparticles of particles.gsf stand", particleMask(), ""},
        {"self_affine.gsf", "Self-affine roughness, rms 6 nm, Hurst exponent 0.8", selfAffine()},
        {"steps.gsf", "Vicinal Au(111), steps of 0.235 nm", steps()},
        {"spherulite.gsf", "Banded polymer spherulites", spherulite()}};
}

}  // namespace asperity
