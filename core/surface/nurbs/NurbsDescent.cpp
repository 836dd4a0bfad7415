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
Vector2 slopeNoise(const NurbsPatch& patch, double positionNoise) {
    return {positionNoise * patch.net.degreeU / (patch.highU - patch.lowU),
            positionNoise * patch.net.degreeV / (patch.highV - patch.lowV)};
}

/// Which parameter is constant along an edge, and what it is there.
int axisAcross(int edge) { return edge >= 2 ? 1 : 0; }
double positionAcross(int edge) { return edge % 2 == 0 ? 0.0 : 1.0; }

/// A search that halves its steps towards an edge never gets there: puts it onto the edge.
Vector2 ontoEdges(const Vector2& position, const Box& box) {
    Vector2 moved = position;
    for (int axis = 0; axis < 2; ++axis) {
        const double near = kOnEdge * (box.high[axis] - box.low[axis]);
        if (position[axis] < box.low[axis] + near) {
            moved[axis] = box.low[axis];
        } else if (position[axis] > box.high[axis] - near) {
            moved[axis] = box.high[axis];
        }
    }
    return moved;
}

NurbsMinimum minimumOf(const BoxMinimum& found) {
    return {.position = found.position,
            .distance = std::sqrt(2.0 * found.model.value),
            .iterations = found.iterations,
            .converged = found.converged,
            .pushedOut = found.pushedOut};
}

constexpr int kMaxProductDegree = 2 * kMaxDegree;
using Binomials = std::array<std::array<double, kMaxProductDegree + 1>, kMaxProductDegree + 1>;

constexpr Binomials kBinomials = [] {
    Binomials table{};
    for (std::size_t n = 0; n <= kMaxProductDegree; ++n) {
        table[n][0] = 1.0;
        for (std::size_t k = 1; k <= n; ++k) {
            table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0.0);
        }
    }
    return table;
}();

double binomial(int n, int k) {
    return kBinomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

struct SlopeRange {
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

}  // namespace

NurbsHalfSquare::NurbsHalfSquare(const NurbsSurface& surface, const Vector3& query,
                                 int patch) noexcept
    : surface_(surface)
    , query_(query)
    , patch_(patch)
    , noise_(kEpsilon * (surface.scale() + query.lpNorm<Eigen::Infinity>())) {}

LocalModel NurbsHalfSquare::operator()(const Vector2& position) const noexcept {
    const int index = patch_ < 0 ? surface_.patchAt(position.x(), position.y()) : patch_;
    const NurbsPatch& patch = surface_.patches()[static_cast<std::size_t>(index)];
    const ParametricSample s = sampleOf(patch, position.x(), position.y());
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
    return minimumOf(found.converged ? found : newton.minimize(ontoEdges(found.position, box)));
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
        const double value = state.position[axis];
        if (surface_.closed()[static_cast<std::size_t>(axis)] && (value == 0.0 || value == 1.0)) {
            Vector2 other = state.position;
            other[axis] = 1.0 - value;
            return goOnTo(within(-1, kWhole, other), state);
        }
    }
    return false;
}

/// Derivative of half the squared distance into the surface from an edge [m^2].
double NurbsDescent::slopeInto(int edge, double along) const noexcept {
    const double across = positionAcross(edge);
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
        const double position = std::clamp(along, 0.0, 1.0);
        const double slope = slopeInto(edge, position);
        if (slope < steepest) {
            steepest = slope;
            best = position;
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
    state.position[axis] = positionAcross(edge);
    state.position[1 - axis] = along;
    LocalModel model = objective(state.position);
    for (int i = 0; i < kMaxMeridianSteps && !state.converged; ++i) {
        const double bend = std::max(model.hessian(axis, axis), 0.5 * model.convex(axis, axis));
        state.position[axis] =
            std::clamp(state.position[axis] - model.gradient[axis] / bend, 0.0, 1.0);
        model = objective(state.position);
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
        const double away = std::abs(state.position[axisAcross(edge)] - positionAcross(edge));
        if (!surface_.collapsed()[static_cast<std::size_t>(edge)] || away > kBesidePole) {
            continue;
        }
        state.pushedOut &= away > 0.0;  // beyond this edge is the surface's other side
        const double along = steepestMeridian(edge);
        if (slopeInto(edge, along) < 0.0) {
            const NurbsMinimum beside = downMeridian(edge, along);
            const NurbsMinimum beyond = within(-1, kWhole, beside.position);
            goOnTo(beyond.distance < beside.distance - rounding_ ? beyond : beside, state);
        }
    }
}

SquaredDistanceNet::SquaredDistanceNet(const BezierNet& net, double positionNoise) noexcept
    : degreeU_(2 * net.degreeU), degreeV_(2 * net.degreeV), leastWeight_(net.at(0, 0)[3]) {
    double greatest = 0.0;  // the farthest control point bounds the products
    double greatestWeight = 0.0;
    // The product of two Bernstein polynomials, the binomial factors taken out.
    std::array<HomogeneousPoint, BezierNet::kMaxPoints> scaled;
    for (int j = 0; j <= net.degreeV; ++j) {
        for (int i = 0; i <= net.degreeU; ++i) {
            greatest = std::max(greatest, net.at(i, j).head<3>().squaredNorm());
            leastWeight_ = std::min(leastWeight_, net.at(i, j)[3]);
            greatestWeight = std::max(greatestWeight, net.at(i, j)[3]);
            scaled[BezierNet::index(i, j)] =
                binomial(net.degreeU, i) * binomial(net.degreeV, j) * net.at(i, j);
        }
    }
    leastWeight_ *= leastWeight_;
    noise_ = 16.0 * std::numeric_limits<double>::epsilon() * greatest +
             4.0 * std::sqrt(greatest) * greatestWeight * positionNoise;
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            Eigen::Vector4d sum = Eigen::Vector4d::Zero();
            for (int j = std::max(0, l - net.degreeV); j <= std::min(l, net.degreeV); ++j) {
                for (int i = std::max(0, k - net.degreeU); i <= std::min(k, net.degreeU); ++i) {
                    sum += scaled[BezierNet::index(i, j)].cwiseProduct(
                        scaled[BezierNet::index(k - i, l - j)]);
                }
            }
            const double share = 1.0 / (binomial(degreeU_, k) * binomial(degreeV_, l));
            distance_[index(k, l)] = share * (sum[0] + sum[1] + sum[2]);
            weight_[index(k, l)] = share * sum[3];
        }
    }
}

bool SquaredDistanceNet::isAtLeast(double square) const noexcept {
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            if (distance_[index(k, l)] < square * weight_[index(k, l)] + noise_) {
                return false;
            }
        }
    }
    return true;
}

bool SquaredDistanceNet::isConvex(double square, double slack) const noexcept {
    Coefficients excess;
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            excess[index(k, l)] = distance_[index(k, l)] - square * weight_[index(k, l)];
        }
    }
    // The coefficients of a derivative are differences of those of the function.
    SlopeRange uu;
    SlopeRange uv;
    SlopeRange vv;
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            const double here = excess[index(k, l)];
            if (k + 2 <= degreeU_) {
                uu.add(here - 2.0 * excess[index(k + 1, l)] + excess[index(k + 2, l)]);
            }
            if (l + 2 <= degreeV_) {
                vv.add(here - 2.0 * excess[index(k, l + 1)] + excess[index(k, l + 2)]);
            }
            if (k < degreeU_ && l < degreeV_) {
                uv.add(here - excess[index(k + 1, l)] - excess[index(k, l + 1)] +
                       excess[index(k + 1, l + 1)]);
            }
        }
    }
    // Each difference has coefficients of a total weight of 4.
    const double noise = 4.0 * noise_;
    const double shift = slack * leastWeight_;
    const double leastU = degreeU_ * (degreeU_ - 1) * (uu.least - noise) + shift;
    const double leastV = degreeV_ * (degreeV_ - 1) * (vv.least - noise) + shift;
    const double mixed =
        degreeU_ * degreeV_ * (std::max(std::abs(uv.least), std::abs(uv.most)) + noise);
    return leastU > 0.0 && leastV > 0.0 && leastU * leastV > mixed * mixed;
}

}  // namespace asperity
