#include "bench/surface/SearchWork.h"

#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/deformation/ContactHeight.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kPixels = 512;
constexpr double kSide = 2048.0_nm;
constexpr double kPathWave = 32.0_nm;  // the shortest of the roughness of the path

constexpr ScanSize kScan{.columns = kPixels, .rows = kPixels, .sizeX = kSide, .sizeY = kSide};

void add(HeightMap& map, const HeightMap& other) {
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.heights[i] += other.heights[i];
    }
}

/// Parallel grooves, sharper at their bottom than the tip: it rests on both walls.
struct Grooves {
    double pitch = 170.0_nm;
    double depth = 34.0_nm;
    double width = 22.0_nm;  ///< half of it, at 1/e of the depth

    [[nodiscard]] double height(double x, double y) const {
        constexpr double kTurn = 0.6;  // [rad]
        const double across = x * std::cos(kTurn) + y * std::sin(kTurn);
        const double off = (across - pitch * std::round(across / pitch)) / width;
        return -depth * std::exp(-off * off);
    }
};

/// A length that runs to and fro between 0 and `span`.
double reflected(double length, double span) {
    const double phase = std::fmod(length, 2.0 * span);
    return phase < span ? phase : 2.0 * span - phase;
}

/// Returns how far a slide has come at a step [m].
double pathLength(std::size_t step) {
    constexpr double kStep = 0.1_nm;
    return kStep * static_cast<double>(step);
}

/// Returns the tip's position at a step, world x, y [m].
Vector2 positionOn(const Slide& slide, std::size_t step) {
    constexpr double kEdge = 120.0_nm;  // not slid over, so that every peer sees the same surface
    constexpr double kHeading = 0.65;   // [rad]
    constexpr double kSpan = kSide - 2.0 * kEdge;
    const double gone = pathLength(step);
    return {slide.corner.x() + kEdge + reflected(gone * std::cos(kHeading), kSpan),
            slide.corner.y() + kEdge + reflected(gone * std::sin(kHeading), kSpan)};
}

/// Heights of the tip's center at which it touches, at every `stepsPerTouch`-th step and at the one
/// after the last [m].
std::vector<double> touchHeights(const BSplineSurface& surface, const Slide& slide) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < slide.steps + slide.stepsPerTouch; i += slide.stepsPerTouch) {
        const Vector2 position = positionOn(slide, i);
        heights.push_back(tipContactHeight(surface, position.x(), position.y(), slide.tipRadius));
    }
    return heights;
}

/// Parameters of the sample's roughness.
struct Roughness {
    double rms = 0.0;           ///< [m]
    double shortestWave = 0.0;  ///< [m]
};

HeightMap roughness(const Roughness& recipe) {
    return selfAffineMap(kScan, {.rms = recipe.rms,
                                 .hurst = 0.8,
                                 .longestWave = 1.0_um,
                                 .rollOffWave = 200.0_nm,
                                 .shortestWave = recipe.shortestWave,
                                 .seed = 19});
}

/// Parameters of the maps of rough samples.
struct ParticleMap {
    int particles = 0;
    Roughness roughness;
};

HeightMap particleMap(const ParticleMap& wanted) {
    constexpr double kRimRounding = 0.8;  // [pixel]
    HeightMap map = sampledMap(kScan, Nanoparticles({.count = wanted.particles,
                                                     .medianRadius = 24.0_nm,
                                                     .spread = 0.4,
                                                     .smallest = 10.0_nm,
                                                     .largest = 60.0_nm,
                                                     .scanTipRadius = 3.0_nm,
                                                     .clearance = 4.0_nm,
                                                     .seed = 17},
                                                    kScan));
    map = smoothed(map, kRimRounding);
    add(map, sampledMap(kScan, AtomicSteps({.stepHeight = 1.0_nm,
                                            .terraceWidth = 120.0_nm,
                                            .edgeWidth = 3.0_nm,
                                            .jitter = 20.0_nm,
                                            .angle = 0.4,
                                            .seed = 18},
                                           kScan)));
    add(map, roughness(wanted.roughness));
    return map;
}

}  // namespace

HeightMap pathMap() {
    return particleMap({.particles = 130, .roughness = {.rms = 1.0_nm, .shortestWave = kPathWave}});
}

HeightMap roughMap() {
    return particleMap({.particles = 80, .roughness = {.rms = 5.0_nm, .shortestWave = 16.0_nm}});
}

HeightMap concaveMap() {
    HeightMap map = sampledMap(kScan, EggBox{.amplitude = 22.0_nm,
                                             .periodX = 97.0_nm,
                                             .periodY = 113.0_nm,
                                             .phaseX = 0.3,
                                             .phaseY = 1.1});
    add(map, sampledMap(kScan, Grooves{}));
    add(map, selfAffineMap(kScan, {.rms = 1.0_nm,
                                   .hurst = 0.8,
                                   .longestWave = 1.0_um,
                                   .rollOffWave = 100.0_nm,
                                   .shortestWave = 16.0_nm,
                                   .seed = 29}));
    return map;
}

HeightMap selfAffineGround(double rms) {
    return roughness({.rms = rms, .shortestWave = kPathWave});
}

std::vector<Vector3> slidingTip(const BSplineSurface& surface, const Slide& slide) {
    constexpr double kMeanGap = 1.0_nm;
    constexpr double kSwing = 2.0_nm;
    constexpr double kSwingLength = 90.0_nm;
    const std::vector<double> heights = touchHeights(surface, slide);
    std::vector<Vector3> centers;
    centers.reserve(slide.steps);
    for (std::size_t i = 0; i < slide.steps; ++i) {
        const Vector2 position = positionOn(slide, i);
        const double gap =
            kMeanGap + kSwing * std::sin(2.0 * std::numbers::pi * pathLength(i) / kSwingLength);
        const std::size_t before = i / slide.stepsPerTouch;
        const double height = std::lerp(heights[before], heights[before + 1],
                                        static_cast<double>(i % slide.stepsPerTouch) /
                                            static_cast<double>(slide.stepsPerTouch));
        centers.emplace_back(position.x(), position.y(), height + gap);
    }
    return centers;
}

std::vector<Vector3> randomTips(const BSplineSurface& surface, std::size_t count,
                                std::uint64_t seed) {
    constexpr double kMaxIndentation = 2.0_nm;
    Random random(seed);
    std::vector<Vector3> centers;
    centers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(0.0, surface.sizeX());
        const double y = random.uniform(0.0, surface.sizeY());
        const double z =
            i % 2 == 0 ? tipContactHeight(surface, x, y, kBenchTipRadius) +
                             random.uniform(-kMaxIndentation, kBenchTipRadius)
                       : surface.at(x, y).height + kBenchTipRadius * random.uniform(-1.0, 3.0);
        centers.emplace_back(x, y, z);
    }
    return centers;
}

}  // namespace asperity
