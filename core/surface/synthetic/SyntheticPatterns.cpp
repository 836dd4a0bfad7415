#include "core/Error.h"
#include "core/Random.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

HeightMap flatMap(const ScanSize& size) {
    constexpr int kMaxPixels = 1 << 15;  // a side
    if (size.columns < 1 || size.rows < 1 || size.columns > kMaxPixels || size.rows > kMaxPixels) {
        throw Error("a synthetic scan has 1 to " + std::to_string(kMaxPixels) + " pixels a side");
    }
    HeightMap map{.columns = size.columns,
                  .rows = size.rows,
                  .pitchX = size.sizeX / size.columns,
                  .pitchY = size.sizeY / size.rows,
                  .heights = {},
                  .invalid = {}};
    map.heights.resize(map.index(map.rows, 0), 0.0);
    requireUsable(map);
    return map;
}

HeightSample EggBox::at(double x, double y) const {
    const double kx = 2.0 * std::numbers::pi / periodX;
    const double ky = 2.0 * std::numbers::pi / periodY;
    const double sx = std::sin(kx * x + phaseX);
    const double cx = std::cos(kx * x + phaseX);
    const double sy = std::sin(ky * y + phaseY);
    const double cy = std::cos(ky * y + phaseY);
    return {.height = amplitude * sx * sy,
            .dx = amplitude * kx * cx * sy,
            .dy = amplitude * ky * sx * cy,
            .dxx = -amplitude * kx * kx * sx * sy,
            .dxy = amplitude * kx * ky * cx * cy,
            .dyy = -amplitude * ky * ky * sx * sy};
}

double TrapezoidGrating::height(double x, double y) const {
    const double across = x * std::cos(angle) + y * std::sin(angle);
    const double phase = across - pitch * std::floor(across / pitch);
    if (phase < topWidth) {
        return depth;
    }
    const double fromTop = std::min(phase - topWidth, pitch - phase);
    return fromTop < flankWidth ? depth * (1.0 - fromTop / flankWidth) : 0.0;
}

AtomicSteps::AtomicSteps(const Recipe& recipe, const ScanSize& size) : recipe_(recipe) {
    if (!(recipe.terraceWidth > 0.0) || !(recipe.edgeWidth > 0.0)) {
        throw Error("terraces and step edges need a positive width");
    }
    // One reach beyond the scan on every side, so that no step is missing in a corner.
    const double reach = size.sizeX + size.sizeY + 10.0 * recipe.edgeWidth;
    constexpr double kMaxTerraces = 1e6;
    if (reach > kMaxTerraces * recipe.terraceWidth) {
        throw Error("the terraces are too narrow for a scan of this size");
    }
    Random random(recipe.seed);
    const int last = static_cast<int>(std::ceil(reach / recipe.terraceWidth));
    for (int k = -last; k <= last; ++k) {
        steps_.push_back((k + 0.5) * recipe.terraceWidth + recipe.jitter * random.normal());
    }
}

double AtomicSteps::height(double x, double y) const {
    const double across = x * std::cos(recipe_.angle) + y * std::sin(recipe_.angle);
    double stepsUp = 0.0;
    for (const double step : steps_) {
        // The logistic step less its value at the origin's side, written so that exp stays finite.
        const double before = step <= 0.0 ? 1.0 : 0.0;
        stepsUp += 0.5 * (1.0 + std::tanh(0.5 * (across - step) / recipe_.edgeWidth)) - before;
    }
    return recipe_.stepHeight * (stepsUp - across / recipe_.terraceWidth);
}

}  // namespace asperity
