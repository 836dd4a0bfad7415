#include "core/map/MapPlan.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/map/PixelCycle.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

std::vector<MapValues> cyclesOf(const MapInstrument& instrument, const MapPlan& plan, int row,
                                const CancelCheck& check) {
    std::vector<MapValues> pixels;
    const bool deviates = hasDeviations(plan);
    for (int column = 0; column < plan.grid.columns; ++column) {
        check();
        VerticalPath path(instrument, plan.position(row, column));
        const CycleStates states = runCycle(path, plan.setpoint);
        pixels.push_back(valuesOf(states, path));
        if (deviates && states.engaged) {
            takeDeviations(instrument.scene(), states.engaged->atSetpoint.state, pixels.back());
        }
    }
    return pixels;
}

constexpr double kLongestStep = 0.5;  // of the tip's radius, between two adjustments of the base

/// Which quantities one way along a row gives.
struct RasterWay {
    double direction;  ///< along x, 1 or -1
    MapQuantity height;
    MapQuantity lateral;
    MapQuantity error;
};

constexpr RasterWay kTrace{1.0, MapQuantity::HeightTrace, MapQuantity::LateralTrace,
                           MapQuantity::ErrorTrace};
constexpr RasterWay kRetrace{-1.0, MapQuantity::HeightRetrace, MapQuantity::LateralRetrace,
                             MapQuantity::ErrorRetrace};

/// Returns whether friction holds the tip down on a wall by about as much as the wall pushes it up:
/// hardly anything of what presses the tip to it shows in the bending, and the base goes on.
bool isJammed(const ProbeSystem& system, const TipState& state, const Vector3& axis) {
    constexpr double kMinShare = 0.05;
    const double friction = system.frictionAt(state.closest.point).coefficient;
    return axis.dot(state.closest.normal + (friction * state.slip)) < kMinShare;
}

/// The tip on its way along a row.
class Raster {
public:
    Raster(const MapInstrument& instrument, double setpoint)
        : instrument_(instrument)
        , held_{.value = setpoint, .axis = bendingAxis(instrument.system().cantilever)} {}

    /// Draws the tip there, where it has engaged; else it engages there.
    void moveTo(const Vector2& position, const RasterWay& way, MapValues& values) {
        const Vector2 whole = tip_ ? Vector2(position - position_) : Vector2::Zero();
        const double longest = kLongestStep * instrument_.system().tipRadius();
        const int steps = std::max(1, static_cast<int>(std::ceil(whole.norm() / longest)));
        for (int i = steps - 1; i >= 0; --i) {
            hold(position - (static_cast<double>(i) / steps) * whole, way.direction);
        }
        record(way, values);
        values[MapQuantity::Iterations] += std::exchange(solved_, 0);
        flags_.set(Validity::NotInEquilibrium, !tip_);
    }

    /// Takes the flags of all states recorded so far.
    [[nodiscard]] ValidityFlags takeFlags() { return std::exchange(flags_, {}); }

private:
    /// Moves the base to the next position, and there until the bending is that of the setpoint.
    void hold(const Vector2& position, double direction) {
        const Vector3 drawn = direction * VerticalPath::kSpeed * Vector3::UnitX();
        position_ = position;
        VerticalPath path(instrument_, position);
        path.setVelocity(drawn);
        if (tip_) {
            tip_ = path.at(tip_->base, tip_->memory);
        }
        if (!tip_ || !tip_->isBonded()) {  // at the beginning, or the sample fell away
            std::optional<Engagement> engaged = engage(path, held_.value);
            tip_ = engaged ? std::optional(std::move(engaged->atSetpoint)) : std::nullopt;
            path.setVelocity(drawn);
            tip_ = tip_ ? std::optional(path.at(tip_->base, tip_->memory)) : std::nullopt;
        }
        tip_ = tip_ ? findForce(path, std::move(*tip_), held_) : std::nullopt;
        letGoWhereStuck();
        solved_ += path.solved();
    }

    /// The tip is lifted off what is no equilibrium, and off a wall that jams it.
    void letGoWhereStuck() {
        if (!tip_) {
            return;
        }
        const TipState& state = tip_->state;
        const bool sticks = state.locked || isJammed(instrument_.system(), state, held_.axis);
        if (sticks || !state.converged) {
            flags_.add(instrument_.validity(state));
            flags_.set(Validity::FrictionLock, sticks);
            tip_.reset();
        }
    }

    void record(const RasterWay& way, MapValues& values) {
        if (!tip_) {
            return;
        }
        const Cantilever& lever = instrument_.system().cantilever;
        const Vector3& force = tip_->state.force;
        const double sensed = held_.axis.dot(force);
        values[way.height] = tip_->base + lever.compliance()(2, 2) * sensed;
        values[way.lateral] = force.x();
        values[way.error] = (sensed - force.z()) / lever.stiffness();
        flags_.add(instrument_.validity(tip_->state));
    }

    const MapInstrument& instrument_;
    SoughtForce held_;
    std::optional<TipAtHeight> tip_;
    Vector2 position_ = Vector2::Zero();  ///< of the base [m]
    ValidityFlags flags_;
    int solved_ = 0;
};

}  // namespace

double setpointOn(const Scene& scene, const std::optional<double>& wanted) {
    const double setpoint = wanted.value_or(scene.description.setpoint);
    if (!isSetpoint(setpoint)) {
        throw Error("the setpoint must lie between " + formatSi(kMinSetpoint, "N") + " and " +
                    formatSi(kMaxSetpoint, "N"));
    }
    return setpoint;
}

Vector2 MapPlan::position(int row, int column) const {
    return {region.left + (column + 0.5) * pitchX(),
            region.bottom + (grid.rows - row - 0.5) * pitchY()};
}

MapPlan planMap(const Scene& scene, const MapRequest& request) {
    if (!scene.description.truth.curve.empty()) {
        throw Error("the instrument of this scene plays a recorded curve ([truth] curve), which is "
                    "of one place: there is no map of it");
    }
    const MapRegion region = regionOf(scene.surface, request);
    const MapPlan plan{.mode = request.mode,
                       .grid = gridOf(scene.surface.grid(), region, request),
                       .region = region,
                       .setpoint = setpointOn(scene, request.setpoint),
                       .quantities = quantitiesOf(request),
                       .truth = request.truth};
    requireDeviations(scene, plan);
    const SceneDescription& description = scene.description;
    const SampleMaterial& material =
        plan.truth ? description.truth.material : description.sample.material;
    if (material.dependsOnTime()) {
        throw Error(
            "a map is of slow cycles, and this sample relaxes or drags the tip in a liquid: "
            "its forces depend on the speed. `asperity curve --speed` has one cycle");
    }
    return plan;
}

std::vector<double> mapRow(const MapInstrument& instrument, const MapPlan& plan, int row,
                           const CancelCheck& check) {
    const std::vector<MapValues> pixels = plan.mode == MapMode::Approach
                                              ? cyclesOf(instrument, plan, row, check)
                                              : rasterLine(instrument, plan, row, check);
    std::vector<double> values;
    values.reserve(plan.quantities.size() * pixels.size());
    for (const MapQuantity quantity : plan.quantities) {
        for (const MapValues& pixel : pixels) {
            values.push_back(pixel[quantity]);
        }
    }
    return values;
}

std::vector<MapValues> rasterLine(const MapInstrument& instrument, const MapPlan& plan, int row,
                                  const CancelCheck& check) {
    std::vector<MapValues> pixels(static_cast<std::size_t>(plan.grid.columns));
    std::vector<ValidityFlags> flags(pixels.size());
    Raster raster(instrument, plan.setpoint);
    const auto visit = [&](int column, const RasterWay& way) {
        check();
        const auto i = static_cast<std::size_t>(column);
        raster.moveTo(plan.position(row, column), way, pixels[i]);
        flags[i].add(raster.takeFlags());
    };
    for (MapValues& pixel : pixels) {
        pixel[MapQuantity::Iterations] = 0.0;
    }
    for (int column = 0; column < plan.grid.columns; ++column) {
        visit(column, kTrace);
    }
    for (int column = plan.grid.columns - 1; column >= 0; --column) {
        visit(column, kRetrace);
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i][MapQuantity::FrictionForce] =
            0.5 * (pixels[i][MapQuantity::LateralRetrace] - pixels[i][MapQuantity::LateralTrace]);
        pixels[i][MapQuantity::Validity] = static_cast<double>(flags[i].bits());
    }
    return pixels;
}

}  // namespace asperity
