#include "core/map/RasterLine.h"

#include "core/map/Engagement.h"
#include "core/map/ForceSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

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

/// Whether friction holds the tip down on a wall by about as much as the wall pushes it up: hardly
/// anything of what presses the tip to it is left along z, and the base goes on.
bool isJammed(const ProbeSystem& system, const TipState& state) {
    constexpr double kLeastShare = 0.05;
    const double friction = system.frictionAt(state.closest.point).coefficient;
    return state.closest.normal.z() + (friction * state.slip.z()) < kLeastShare;
}

/// The tip on its way along a row.
class Raster {
public:
    Raster(const MapInstrument& instrument, double setpoint)
        : instrument_(instrument), setpoint_(setpoint) {}

    /// Draws the tip there, where it has engaged; else it engages there.
    void moveTo(const Vector2& place, const RasterWay& way, MapValues& values) {
        const Vector2 whole = tip_ ? Vector2(place - place_) : Vector2::Zero();
        const double longest = kLongestStep * instrument_.system().tipRadius();
        const int steps = std::max(1, static_cast<int>(std::ceil(whole.norm() / longest)));
        for (int i = steps - 1; i >= 0; --i) {
            hold(place - (static_cast<double>(i) / steps) * whole, way.direction);
        }
        record(way, values);
        values[MapQuantity::Iterations] += std::exchange(solved_, 0);
        flags_.set(Validity::NotInEquilibrium, !tip_);
    }

    /// Of all states recorded so far.
    [[nodiscard]] ValidityFlags takeFlags() { return std::exchange(flags_, {}); }

private:
    /// Moves the base to the next place and there to the setpoint.
    void hold(const Vector2& place, double direction) {
        const Vector3 drawn = direction * VerticalPath::kSpeed * Vector3::UnitX();
        place_ = place;
        VerticalPath path(instrument_, place);
        path.setVelocity(drawn);
        if (tip_) {
            tip_ = path.at(tip_->base, tip_->memory);
        }
        if (!tip_ || !tip_->isBonded()) {  // at the beginning, or the sample fell away
            std::optional<Engagement> engaged = engage(path, setpoint_);
            tip_ = engaged ? std::optional(std::move(engaged->atSetpoint)) : std::nullopt;
            path.setVelocity(drawn);
            tip_ = tip_ ? std::optional(path.at(tip_->base, tip_->memory)) : std::nullopt;
        }
        tip_ = tip_ ? findForce(path, std::move(*tip_), setpoint_) : std::nullopt;
        letGoWhereStuck();
        solved_ += path.solved();
    }

    /// The tip is lifted off what is no equilibrium, and off a wall that jams it.
    void letGoWhereStuck() {
        if (!tip_) {
            return;
        }
        const TipState& state = tip_->state;
        const bool sticks = state.locked || isJammed(instrument_.system(), state);
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
        const double sensed = leverSignals(lever, force).bending / lever.bendingPerFz();
        values[way.height] = VerticalPath(instrument_, place_).recordedHeight(*tip_);
        values[way.lateral] = force.x();
        values[way.error] = (sensed - setpoint_) / lever.stiffness();
        flags_.add(instrument_.validity(tip_->state));
    }

    const MapInstrument& instrument_;
    double setpoint_;  ///< [N]
    std::optional<TipAtHeight> tip_;
    Vector2 place_ = Vector2::Zero();  ///< of the base [m]
    ValidityFlags flags_;
    int solved_ = 0;
};

}  // namespace

std::vector<MapValues> rasterLine(const MapInstrument& instrument, const MapPlan& plan, int row,
                                  const CancelCheck& check) {
    std::vector<MapValues> pixels(static_cast<std::size_t>(plan.grid.columns));
    std::vector<ValidityFlags> flags(pixels.size());
    Raster raster(instrument, plan.setpoint);
    const auto visit = [&](int column, const RasterWay& way) {
        check();
        const auto i = static_cast<std::size_t>(column);
        raster.moveTo(plan.place(row, column), way, pixels[i]);
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
        pixels[i][MapQuantity::Validity] = flags[i].bits();
    }
    return pixels;
}

}  // namespace asperity
