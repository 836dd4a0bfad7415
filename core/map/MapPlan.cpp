#include "core/map/MapPlan.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/map/MapDeviations.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kMaxPixels = 65536;  // along a side

std::string keysOf(MapMode mode) {
    std::string keys;
    for (const MapQuantityRow& row : kEnumTable<MapQuantity>) {
        if (hasQuantity(mode, row)) {
            keys += (keys.empty() ? "" : ", ") + std::string(row.key);
        }
    }
    return keys;
}

std::vector<MapQuantity> quantitiesOf(const MapRequest& request) {
    for (const std::string& key : request.quantities) {
        const bool isKnown =
            std::ranges::any_of(kEnumTable<MapQuantity>, [&](const MapQuantityRow& row) {
                return row.key == key && hasQuantity(request.mode, row);
            });
        if (!isKnown) {
            throw Error("mode " + std::string(keyOf(request.mode)) + " has no quantity '" + key +
                        "': expected " + keysOf(request.mode));
        }
    }
    std::vector<MapQuantity> chosen;
    for (const MapQuantityRow& row : kEnumTable<MapQuantity>) {
        const bool isNamed =
            std::ranges::find(request.quantities, row.key) != request.quantities.end();
        const bool isAsked =
            isNamed || (row.onRequest ? request.deviations : request.quantities.empty());
        if (isAsked && hasQuantity(request.mode, row)) {
            chosen.push_back(row.value);
        }
    }
    return chosen;
}

MapRegion regionOf(const BSplineSurface& surface, const MapRequest& request) {
    const MapRegion whole{0.0, 0.0, surface.sizeX(), surface.sizeY()};
    const MapRegion region = request.region.value_or(whole);
    const bool isInside = region.left >= whole.left && region.bottom >= whole.bottom &&
                          region.right <= whole.right && region.top <= whole.top;
    if (!isInside) {
        throw Error(formatted("the region of the map lies outside the scan, which is %.9g m wide "
                              "and %.9g m high",
                              whole.right, whole.top));
    }
    if (!(region.right > region.left) || !(region.top > region.bottom)) {
        throw Error("the region of the map is empty: expected x0 < x1 and y0 < y1");
    }
    return region;
}

/// Pixels of a pitch in a length.
int pixelsIn(double length, double pitch) {
    return std::max(1, static_cast<int>(std::lround(length / pitch)));
}

MapGrid gridOf(const BSplineSurface::Grid& scan, const MapRegion& region,
               const MapRequest& request) {
    const MapGrid grid =
        request.grid.value_or(MapGrid{pixelsIn(region.right - region.left, scan.pitchX),
                                      pixelsIn(region.top - region.bottom, scan.pitchY)});
    if (std::min(grid.columns, grid.rows) < 1 || std::max(grid.columns, grid.rows) > kMaxPixels) {
        throw Error("the grid of the map must have 1 to 65536 pixels along each side");
    }
    return grid;
}

void requireDeviations(const Scene& scene, const MapPlan& plan) {
    if (hasDeviations(plan) && plan.truth) {
        throw Error("standard deviations are of the model: the simulated true instrument has none");
    }
    if (hasDeviations(plan) && !scene.description.uncertainty.enabled) {
        throw Error("the scene has standard deviations off: [uncertainty] enabled = false");
    }
}

}  // namespace

double setpointOn(const Scene& scene, const std::optional<double>& wanted) {
    const double setpoint = wanted.value_or(scene.description.setpoint);
    if (!isSetpoint(setpoint)) {
        throw Error("the setpoint must lie between " + formatSi(kMinSetpoint, "N") + " and " +
                    formatSi(kMaxSetpoint, "N"));
    }
    return setpoint;
}

Vector2 MapPlan::place(int row, int column) const {
    return {region.left + (column + 0.5) * pitchX(),
            region.bottom + (grid.rows - row - 0.5) * pitchY()};
}

MapPlan planMap(const Scene& scene, const MapRequest& request) {
    const MapRegion region = regionOf(scene.surface, request);
    const MapPlan plan{.mode = request.mode,
                       .grid = gridOf(scene.surface.grid(), region, request),
                       .region = region,
                       .setpoint = setpointOn(scene, request.setpoint),
                       .quantities = quantitiesOf(request),
                       .truth = request.truth};
    requireDeviations(scene, plan);
    return plan;
}

}  // namespace asperity
