#include "core/surface/nurbs/NurbsDescent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kEscapeStep = 0.05;  // off a saddle, of the parameters' range
constexpr double kOnEdge = 1e-9;      // of the width of a box
constexpr int kMaxLegs = 3;           // of a way across seams and poles
constexpr int kMeridians = 16;
constexpr double kBesidePole = 1e-7;  // of the parameter's range
constexpr int kMaxMeridianSteps = 20;
constexpr int kMeridianHalvings = 22;  // down to 1e-8 of the parameter's range

const Box kWhole{.low = Vector2::Zero(), .high = Vector2::Ones()};

/// Rounding of Su and Sv [m]: differences of control points over the width of a patch.
Vector2 slopeNoise(const NurbsPatch& patch, double placeNoise) {
    return {placeNoise * patch.net.degreeU / (patch.highU - patch.lowU),
            placeNoise * patch.net.degreeV / (patch.highV - patch.lowV)};
}

/// Which parameter is constant along an edge, and what it is there.
int axisAcross(int edge) { return edge >= 2 ? 1 : 0; }
double placeAcross(int edge) { return edge % 2 == 0 ? 0.0 : 1.0; }

/// A search that halves its steps towards an edge never gets there: puts it onto the edge.
Vector2 ontoEdges(const Vector2& place, const Box& box) {
    Vector2 moved = place;
    for (int axis = 0; axis < 2; ++axis) {
        const double near = kOnEdge * (box.high[axis] - box.low[axis]);
        if (place[axis] < box.low[axis] + near) {
            moved[axis] = box.low[axis];
        } else if (place[axis] > box.high[axis] - near) {
            moved[axis] = box.high[axis];
        }
    }
    return moved;
}

NurbsMinimum minimumOf(const BoxMinimum& found) {
    return {.place = found.place,
            .distance = std::sqrt(2.0 * found.model.value),
            .iterations = found.iterations,
            .converged = found.converged,
            .pushedOut = found.pushedOut};
}

}  // namespace

NurbsHalfSquare::NurbsHalfSquare(const NurbsSurface& surface, const Vector3& query,
                                 int patch) noexcept
    : surface_(surface)
    , query_(query)
    , patch_(patch)
    , noise_(kEpsilon * (surface.scale() + query.lpNorm<Eigen::Infinity>())) {}

LocalModel NurbsHalfSquare::operator()(const Vector2& place) const noexcept {
    const int index = patch_ < 0 ? surface_.patchAt(place.x(), place.y()) : patch_;
    const NurbsPatch& patch = surface_.patches()[static_cast<std::size_t>(index)];
    const ParametricSample s = sampleOf(patch, place.x(), place.y());
    const Vector3 r = s.point - query_;
    LocalModel model;
    model.value = 0.5 * r.squaredNorm();
    model.gradient = Vector2(r.dot(s.du), r.dot(s.dv));
    const double mixed = s.du.dot(s.dv);
    model.convex << s.du.squaredNorm(), mixed, mixed, s.dv.squaredNorm();
    model.hessian << r.dot(s.duu), r.dot(s.duv), r.dot(s.duv), r.dot(s.dvv);
    model.hessian += model.convex;
    // At a pole one derivative is 0: the stand-in stays regular.
    model.convex += Matrix2::Identity() * (1e-9 * model.convex.trace() + noise_ * noise_);
    model.valueNoise = r.lpNorm<1>() * noise_;
    model.gradientNoise = noise_ * Vector2(s.du.norm(), s.dv.norm()) +
                          r.norm() * slopeNoise(patch, kEpsilon * surface_.scale()) +
                          kEpsilon * model.hessian.cwiseAbs().rowwise().sum();
    return model;
}

NurbsDescent::NurbsDescent(const NurbsSurface& surface, const Vector3& query) noexcept
    : surface_(surface)
    , query_(query)
    , rounding_(8.0 * kEpsilon * (surface.scale() + query.lpNorm<Eigen::Infinity>())) {}

NurbsMinimum NurbsDescent::within(int patch, const Box& box, const Vector2& start) const noexcept {
    const NurbsHalfSquare objective(surface_, query_, patch);
    const double width = (box.high - box.low).minCoeff();
    const BoxNewton newton(objective, box, kEscapeStep * width);
    const BoxMinimum found = newton.minimize(start);
    return minimumOf(found.converged ? found : newton.minimize(ontoEdges(found.place, box)));
}

NurbsMinimum NurbsDescent::from(const Vector2& start) const noexcept {
    NurbsMinimum state = within(-1, kWhole, start);
    for (int leg = 0; leg < kMaxLegs && crossSeam(state); ++leg) {
    }
    leavePole(state);
    return state;
}

/// Goes on to what a search from elsewhere found, if that is nearer, or as near to rounding and a
/// proper minimum; whether it did.
bool NurbsDescent::goOnTo(NurbsMinimum next, NurbsMinimum& state) const noexcept {
    next.iterations += state.iterations;
    state.iterations = next.iterations;
    const bool isProper = next.converged && !next.pushedOut;
    if (next.distance > state.distance + (isProper ? rounding_ : -rounding_)) {
        return false;
    }
    state = next;
    return true;
}

bool NurbsDescent::crossSeam(NurbsMinimum& state) const noexcept {
    if (!state.pushedOut) {
        return false;
    }
    for (int axis = 0; axis < 2; ++axis) {
        const double place = state.place[axis];
        if (surface_.closed()[static_cast<std::size_t>(axis)] && (place == 0.0 || place == 1.0)) {
            Vector2 other = state.place;
            other[axis] = 1.0 - place;
            return goOnTo(within(-1, kWhole, other), state);
        }
    }
    return false;
}

/// Derivative of half the squared distance into the surface from an edge [m^2].
double NurbsDescent::slopeInto(int edge, double along) const noexcept {
    const double across = placeAcross(edge);
    const bool alongU = axisAcross(edge) == 1;
    const ParametricSample s = alongU ? surface_.at(along, across) : surface_.at(across, along);
    const double slope = (s.point - query_).dot(alongU ? s.dv : s.du);
    return across == 0.0 ? slope : -slope;
}

/// The meridian along which the distance falls most steeply from a pole: where it leaves the edge.
double NurbsDescent::steepestMeridian(int edge) const noexcept {
    double best = 0.0;
    double steepest = std::numeric_limits<double>::max();
    const auto tryAt = [&](double along) {
        const double place = std::clamp(along, 0.0, 1.0);
        const double slope = slopeInto(edge, place);
        if (slope < steepest) {
            steepest = slope;
            best = place;
        }
    };
    for (int i = 0; i < kMeridians; ++i) {
        tryAt((i + 0.5) / kMeridians);
    }
    double step = 0.5 / kMeridians;
    for (int halving = 0; halving < kMeridianHalvings; ++halving) {
        const double middle = best;
        tryAt(middle - step);
        tryAt(middle + step);
        step *= 0.5;
    }
    return best;
}

/// The minimum along one meridian, from the pole on.
NurbsMinimum NurbsDescent::downMeridian(int edge, double along) const noexcept {
    const int axis = axisAcross(edge);
    const NurbsHalfSquare objective(surface_, query_, -1);
    NurbsMinimum state;
    state.place[axis] = placeAcross(edge);
    state.place[1 - axis] = along;
    LocalModel model = objective(state.place);
    for (int i = 0; i < kMaxMeridianSteps && !state.converged; ++i) {
        const double bend = std::max(model.hessian(axis, axis), 0.5 * model.convex(axis, axis));
        state.place[axis] = std::clamp(state.place[axis] - model.gradient[axis] / bend, 0.0, 1.0);
        model = objective(state.place);
        state.converged = std::abs(model.gradient[axis]) <= 4.0 * model.gradientNoise[axis];
        ++state.iterations;
    }
    state.distance = std::sqrt(2.0 * model.value);
    return state;
}

/// At a pole all meridians begin, and beside it the distance hardly depends on them: Newton's
/// method may have stopped there, or have come down a wrong one.
void NurbsDescent::leavePole(NurbsMinimum& state) const noexcept {
    for (int edge = 0; edge < 4; ++edge) {
        const double away = std::abs(state.place[axisAcross(edge)] - placeAcross(edge));
        if (!surface_.collapsed()[static_cast<std::size_t>(edge)] || away > kBesidePole) {
            continue;
        }
        state.pushedOut &= away > 0.0;  // beyond this edge is the surface's other side
        const double along = steepestMeridian(edge);
        if (slopeInto(edge, along) < 0.0) {
            const NurbsMinimum beside = downMeridian(edge, along);
            const NurbsMinimum beyond = within(-1, kWhole, beside.place);
            goOnTo(beyond.distance < beside.distance - rounding_ ? beyond : beside, state);
        }
    }
}

}  // namespace asperity
