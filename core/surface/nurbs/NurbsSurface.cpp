#include "core/surface/nurbs/NurbsSurface.h"

#include "core/surface/nurbs/NurbsDecomposition.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Edges, as collapsed() counts them.
enum Edge : int { kLowU, kHighU, kLowV, kHighV };

constexpr double kSamePoint = 1e-13;  // of the surface's scale
/// So near to a pole, in shares of its patch, the derivative around it is more rounding than value.
constexpr double kNearPole = 1e-3;
/// Rounding of a curvature, as a share of the largest one.
constexpr double kFlat = 1e-9;
/// Unit normals that differ by more make an edge.
constexpr double kSharp = 1e-5;
/// Three directions whose determinant is smaller are no three directions.
constexpr double kParallel = 1e-9;

std::size_t spanAt(const std::vector<double>& breaks, double place) {
    const auto next = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, place);
    return static_cast<std::size_t>(next - breaks.begin()) - 1;
}

/// From derivatives by the patch's parameters to those by the surface's.
ParametricSample stretched(ParametricSample s, const NurbsPatch& patch) {
    const double perU = 1.0 / (patch.highU - patch.lowU);
    const double perV = 1.0 / (patch.highV - patch.lowV);
    s.du *= perU;
    s.dv *= perV;
    s.duu *= perU * perU;
    s.duv *= perU * perV;
    s.dvv *= perV * perV;
    return s;
}

bool isAlongU(int edge) { return edge == kLowV || edge == kHighV; }

}  // namespace

NurbsSurface::NurbsSurface(const Net& net) {
    NurbsDecomposition pieces = decomposed(net);
    breaksU_ = std::move(pieces.breaksU);
    breaksV_ = std::move(pieces.breaksV);
    patches_ = std::move(pieces.patches);
    boxes_ = boxTree(patches_);
    scale_ = bounds().low.cwiseAbs().cwiseMax(bounds().high.cwiseAbs()).maxCoeff();
    findClosedEdges();
    findConcavity();
}

ParametricSample NurbsSurface::at(double u, double v) const noexcept {
    const double inU = std::clamp(u, 0.0, 1.0);
    const double inV = std::clamp(v, 0.0, 1.0);
    const NurbsPatch& patch = patches_[static_cast<std::size_t>(patchAt(inU, inV))];
    return sampleOf(patch, inU, inV);
}

ParametricSample sampleOf(const NurbsPatch& patch, double u, double v) noexcept {
    return stretched(patch.net.sample((u - patch.lowU) / (patch.highU - patch.lowU),
                                      (v - patch.lowV) / (patch.highV - patch.lowV)),
                     patch);
}

int NurbsSurface::patchAt(double u, double v) const noexcept {
    return static_cast<int>(spanAt(breaksV_, v) * (breaksU_.size() - 1) + spanAt(breaksU_, u));
}

Vector3 NurbsSurface::edgePoint(int edge, double along) const noexcept {
    const double across = edge == kLowU || edge == kLowV ? 0.0 : 1.0;
    return isAlongU(edge) ? at(along, across).point : at(across, along).point;
}

/// Told by more places than a polynomial of this degree has zeros, in every patch.
void NurbsSurface::findClosedEdges() {
    const double same = kSamePoint * scale_;
    closed_ = {true, true};
    collapsed_ = {true, true, true, true};
    for (int edge = kLowU; edge <= kHighV; ++edge) {
        const std::vector<double>& breaks = isAlongU(edge) ? breaksU_ : breaksV_;
        for (std::size_t span = 0; span + 1 < breaks.size(); ++span) {
            constexpr int kPlaces = 2 * kMaxDegree + 1;
            for (int i = 0; i <= kPlaces; ++i) {
                const double along =
                    std::lerp(breaks[span], breaks[span + 1], static_cast<double>(i) / kPlaces);
                const Vector3 point = edgePoint(edge, along);
                if ((point - edgePoint(edge, 0.0)).norm() > same) {
                    collapsed_[edge] = false;
                }
                const int opposite = edge ^ 1;
                if ((point - edgePoint(opposite, along)).norm() > same) {
                    closed_[isAlongU(edge) ? 1 : 0] = false;
                }
            }
        }
    }
}

void NurbsSurface::findConcavity() {
    constexpr int kPlaces = 5;
    if (hasCrease()) {
        concavity_ = kCrease;
        return;
    }
    double largest = 0.0;
    for (const NurbsPatch& patch : patches_) {
        for (int i = 0; i < kPlaces; ++i) {
            const double u = std::lerp(patch.lowU, patch.highU, (i + 0.5) / kPlaces);
            for (int j = 0; j < kPlaces; ++j) {
                const double v = std::lerp(patch.lowV, patch.highV, (j + 0.5) / kPlaces);
                const PrincipalCurvatures bend = curvatures(u, v);
                largest = std::max(largest, std::abs(bend.largest));
                concavity_ = std::max(concavity_, -bend.smallest);
            }
        }
    }
    if (concavity_ < kFlat * std::max(largest, 1.0 / scale_)) {
        concavity_ = 0.0;
    }
}

/// Whether the tangent planes of two patches differ where these meet.
bool NurbsSurface::hasCrease() const noexcept {
    constexpr int kPlaces = 3;
    constexpr double kAside = 1e-9;  // of the parameters' range
    const auto bendsBetween = [this](double u0, double v0, double u1, double v1) {
        return (normal(u0, v0) - normal(u1, v1)).norm() > kSharp;
    };
    for (const NurbsPatch& patch : patches_) {
        for (int i = 0; i < kPlaces; ++i) {
            const double share = (i + 0.5) / kPlaces;
            const double u = std::lerp(patch.lowU, patch.highU, share);
            const double v = std::lerp(patch.lowV, patch.highV, share);
            if ((patch.highU < 1.0 && bendsBetween(patch.highU - kAside, v, patch.highU, v)) ||
                (patch.highV < 1.0 && bendsBetween(u, patch.highV - kAside, u, patch.highV))) {
                return true;
            }
        }
    }
    return false;
}

/// The collapsed edge beside which the place lies, or -1.
int NurbsSurface::poleNear(double u, double v) const noexcept {
    const std::array<double, 4> away{u / breaksU_[1], (1.0 - u) / (1.0 - *(breaksU_.end() - 2)),
                                     v / breaksV_[1], (1.0 - v) / (1.0 - *(breaksV_.end() - 2))};
    for (int edge = kLowU; edge <= kHighV; ++edge) {
        if (collapsed_[edge] && away[edge] < kNearPole) {
            return edge;
        }
    }
    return -1;
}

/// Direction of the derivative along a collapsed edge near it. It grows from 0 at the edge as the
/// integral of Suv; Gauss's rule with two places is exact to the third order of the distance.
Vector3 NurbsSurface::directionAroundPole(int edge, double u, double v) const noexcept {
    constexpr double kGauss = 0.21132486540518713;
    const bool isLow = edge == kLowU || edge == kLowV;
    const double start = isLow ? 0.0 : 1.0;
    Vector3 sum = Vector3::Zero();
    for (const double share : {kGauss, 1.0 - kGauss}) {
        sum += isAlongU(edge) ? at(u, std::lerp(start, v, share)).duv
                              : at(std::lerp(start, u, share), v).duv;
    }
    return isLow ? sum : Vector3(-sum);
}

Vector3 NurbsSurface::normal(double u, double v) const noexcept {
    const double inU = std::clamp(u, 0.0, 1.0);
    const double inV = std::clamp(v, 0.0, 1.0);
    ParametricSample s = at(inU, inV);
    const int pole = poleNear(inU, inV);
    if (pole >= 0) {
        (isAlongU(pole) ? s.du : s.dv) = directionAroundPole(pole, inU, inV);
    }
    // Scaled first: the square of a product of two small lengths would vanish.
    const Vector3 across = s.du.stableNormalized().cross(s.dv.stableNormalized());
    const double length = across.norm();
    return length > 0.0 ? Vector3(across / length) : Vector3(Vector3::UnitZ());
}

PrincipalCurvatures NurbsSurface::curvatures(double u, double v) const noexcept {
    const double inU = std::clamp(u, 0.0, 1.0);
    const double inV = std::clamp(v, 0.0, 1.0);
    const int pole = poleNear(inU, inV);
    if (pole >= 0) {
        return curvaturesOfPole(pole, isAlongU(pole) ? inU : inV);
    }
    return principalCurvatures(at(inU, inV), normal(inU, inV));
}

/// The curves that run into the pole have three normal curvatures there, by Euler's theorem enough
/// for the curvature of the surface in all directions.
PrincipalCurvatures NurbsSurface::curvaturesOfPole(int edge, double along) const noexcept {
    const double across = edge == kLowU || edge == kLowV ? 0.0 : 1.0;
    const Vector3 normal =
        isAlongU(edge) ? this->normal(along, across) : this->normal(across, along);
    const Vector3 axis = normal.unitOrthogonal();
    const Vector3 other = normal.cross(axis);
    Matrix3 directions;
    Vector3 curvatures;
    for (int i = 0; i < 3; ++i) {
        const double place = 0.125 * i;
        const ParametricSample s = isAlongU(edge) ? at(place, across) : at(across, place);
        const Vector3 tangent = isAlongU(edge) ? s.dv : s.du;
        const Vector3 bend = isAlongU(edge) ? s.dvv : s.duu;
        const double x = tangent.dot(axis);
        const double y = tangent.dot(other);
        const double square = std::max(tangent.squaredNorm(), std::numeric_limits<double>::min());
        directions.row(i) = Vector3(x * x, 2.0 * x * y, y * y) / square;
        curvatures[i] = -bend.dot(normal) / square;
    }
    if (!(std::abs(directions.determinant()) > kParallel)) {
        return {};
    }
    const Vector3 form = directions.inverse() * curvatures;
    const double mean = 0.5 * (form[0] + form[2]);
    const double spread = std::hypot(0.5 * (form[0] - form[2]), form[1]);
    return {mean + spread, mean - spread};
}

PrincipalCurvatures principalCurvatures(const ParametricSample& s, const Vector3& normal) noexcept {
    // An orthonormal frame of the tangent plane: in it the second form is the shape operator, and
    // the difference of its eigenvalues comes without cancellation.
    const double lengthU = s.du.norm();
    const Vector3 axis = s.du.stableNormalized();
    const Vector3 other = normal.cross(axis);
    const double skew = s.dv.dot(axis);
    const double lengthV = s.dv.dot(other);
    if (!(lengthU > 0.0 && lengthV > 0.0)) {
        return {};
    }
    const double uu = s.duu.dot(normal) / (lengthU * lengthU);
    const double uv = (s.duv.dot(normal) / lengthU - skew * uu) / lengthV;
    const double vv =
        (s.dvv.dot(normal) - 2.0 * skew * lengthV * uv - skew * skew * uu) / (lengthV * lengthV);
    const double mean = -0.5 * (uu + vv);
    const double spread = std::hypot(0.5 * (uu - vv), uv);
    return {mean + spread, mean - spread};
}

}  // namespace asperity
