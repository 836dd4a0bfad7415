#include "core/surface/nurbs/NurbsSurface.h"

#include "core/Error.h"
#include "core/surface/HeightMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace asperity {

namespace {

/// Edges, as collapsed() counts them.
enum Edge : int { kLowU, kHighU, kLowV, kHighV };

constexpr double kSameControlPoint = 1e-13;  // of the surface's scale
/// So near to a pole, in shares of its patch, the derivative around it is more rounding than value.
constexpr double kNearPole = 1e-3;
/// Rounding of a curvature, as a share of the largest one.
constexpr double kFlat = 1e-9;
/// Unit normals that differ by more make an edge.
constexpr double kSharp = 1e-5;
/// Three directions whose determinant is smaller are no three directions.
constexpr double kParallel = 1e-9;

std::size_t spanAt(const std::vector<double>& breaks, double position) {
    const auto next = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, position);
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

void require(bool holds, const std::string& sentence) {
    if (!holds) {
        throw Error("a NURBS surface " + sentence);
    }
}

bool isFinite(double value) { return isFiniteHeight(value); }

/// One parameter of the surface.
struct KnotAxis {
    const std::vector<double>& knots;
    int degree;

    [[nodiscard]] int controls() const { return static_cast<int>(knots.size()) - degree - 1; }
    [[nodiscard]] double low() const { return knots[static_cast<std::size_t>(degree)]; }
    [[nodiscard]] double high() const { return knots[static_cast<std::size_t>(controls())]; }
    /// A knot's position among 0 to 1.
    [[nodiscard]] double share(double knot) const { return (knot - low()) / (high() - low()); }
};

void check(const KnotAxis& axis, const std::string& name) {
    const std::string knots = "must have knots along " + name + " that ";
    require(axis.degree >= 1 && axis.degree <= kMaxDegree,
            "must have a degree from 1 to " + std::to_string(kMaxDegree) + " along " + name);
    require(axis.controls() > axis.degree, knots + "are at least twice the degree and two");
    require(std::all_of(axis.knots.begin(), axis.knots.end(), isFinite),
            knots + "are finite numbers");
    require(std::is_sorted(axis.knots.begin(), axis.knots.end()), knots + "never fall");
    require(axis.high() > axis.low() && isFinite(axis.high() - axis.low()),
            knots + "span a length");
    for (auto knot = axis.knots.begin(); knot != axis.knots.end(); ++knot) {
        const auto repeated = std::upper_bound(knot, axis.knots.end(), *knot) - knot;
        const bool inside = *knot > axis.low() && *knot < axis.high();
        require(!inside || repeated <= axis.degree,
                knots + "are repeated inside no more often than the degree");
    }
}

void checkPoints(const NurbsSurface::Net& net, std::size_t count) {
    require(net.points.size() == count, "must have " + std::to_string(count) +
                                            " control points for its knots, not " +
                                            std::to_string(net.points.size()));
    require(net.weights.empty() || net.weights.size() == count,
            "must have one weight a control point, or none");
    for (const Vector3& point : net.points) {
        for (int axis = 0; axis < 3; ++axis) {
            require(isFinite(point[axis]) && std::abs(point[axis]) <= NurbsSurface::kMaxCoordinate,
                    "must have control points within 1e9 m of the origin");
        }
    }
    if (net.weights.empty()) {
        return;
    }
    require(std::all_of(net.weights.begin(), net.weights.end(),
                        [](double weight) { return isFinite(weight) && weight > 0.0; }),
            "must have weights that are positive numbers");
    const auto [least, most] = std::minmax_element(net.weights.begin(), net.weights.end());
    require(*most / NurbsSurface::kWeightRatio <= *least,
            "must have weights within a factor of a million of each other");
}

/// Returns where the patches meet along one parameter: the last knot of each repeated one.
std::vector<std::size_t> spansOf(const KnotAxis& axis) {
    std::vector<std::size_t> spans;
    const auto controls = static_cast<std::size_t>(axis.controls());
    for (auto k = static_cast<std::size_t>(axis.degree); k < controls; ++k) {
        if (axis.knots[k + 1] > axis.knots[k]) {
            spans.push_back(k);
        }
    }
    return spans;
}

std::vector<double> breaksOf(const KnotAxis& axis) {
    std::vector<double> breaks;
    for (const std::size_t span : spansOf(axis)) {
        breaks.push_back(axis.share(axis.knots[span]));
    }
    breaks.push_back(1.0);
    return breaks;
}

using Row = std::array<HomogeneousPoint, BezierNet::kMaxAlong>;

/// The blossom of the spline in one span, `highs` of its arguments the span's end, the others its
/// start: the Bezier control point number `highs`. Source: The NURBS Book, 5.3 (there by inserting
/// knots).
HomogeneousPoint blossom(const KnotAxis& axis, std::size_t span, int highs, Row row) {
    const auto degree = static_cast<std::size_t>(axis.degree);
    for (std::size_t r = 1; r <= degree; ++r) {
        const bool isHigh = r <= static_cast<std::size_t>(highs);
        const double argument = axis.knots[isHigh ? span + 1 : span];
        for (std::size_t i = degree; i >= r; --i) {
            const double low = axis.knots[span - degree + i];
            const double high = axis.knots[span + 1 + i - r];
            const double share = (argument - low) / (high - low);
            row[i] = (1.0 - share) * row[i - 1] + share * row[i];
        }
    }
    return row[degree];
}

/// Control points of the spline in one span to those of its Bezier piece.
Row bezierRow(const KnotAxis& axis, std::size_t span, const Row& row) {
    Row bezier;
    for (int i = 0; i <= axis.degree; ++i) {
        bezier[static_cast<std::size_t>(i)] = blossom(axis, span, i, row);
    }
    return bezier;
}

HomogeneousPoint homogeneous(const NurbsSurface::Net& net, std::size_t index) {
    const double weight = net.weights.empty() ? 1.0 : net.weights[index];
    HomogeneousPoint point;
    point << weight * net.points[index], weight;
    return point;
}

BezierNet bezierNet(const NurbsSurface::Net& net, std::size_t spanU, std::size_t spanV) {
    const KnotAxis u{net.knotsU, net.degreeU};
    const KnotAxis v{net.knotsV, net.degreeV};
    const auto columns = static_cast<std::size_t>(u.controls());
    BezierNet bezier;
    bezier.degreeU = net.degreeU;
    bezier.degreeV = net.degreeV;
    for (int j = 0; j <= net.degreeV; ++j) {
        const std::size_t start = (spanV - net.degreeV + j) * columns + spanU - net.degreeU;
        Row row;
        for (int i = 0; i <= net.degreeU; ++i) {
            row[i] = homogeneous(net, start + i);
        }
        row = bezierRow(u, spanU, row);
        std::copy_n(row.begin(), net.degreeU + 1, &bezier.at(0, j));
    }
    for (int i = 0; i <= net.degreeU; ++i) {
        Row column;
        for (int j = 0; j <= net.degreeV; ++j) {
            column[j] = bezier.at(i, j);
        }
        column = bezierRow(v, spanV, column);
        for (int j = 0; j <= net.degreeV; ++j) {
            bezier.at(i, j) = column[j];
        }
    }
    return bezier;
}

/// With positive weights a patch lies in the convex hull of its control points.
PatchBox boxOf(const BezierNet& net, int patch) {
    PatchBox box{.low = net.position(0, 0), .high = net.position(0, 0), .patch = patch};
    for (int j = 0; j <= net.degreeV; ++j) {
        for (int i = 0; i <= net.degreeU; ++i) {
            box.low = box.low.cwiseMin(net.position(i, j));
            box.high = box.high.cwiseMax(net.position(i, j));
        }
    }
    return box;
}

/// Builds the tree from the leaves of `order` [from, to): halves them along their longest side.
int addBox(std::vector<PatchBox>& boxes, std::span<int> order) {
    PatchBox box = boxes[static_cast<std::size_t>(order.front())];
    if (order.size() == 1) {
        return order.front();
    }
    for (const int leaf : order) {
        const PatchBox& other = boxes[static_cast<std::size_t>(leaf)];
        box.low = box.low.cwiseMin(other.low);
        box.high = box.high.cwiseMax(other.high);
    }
    int axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const auto middleOf = [&](int leaf) {
        const PatchBox& leafBox = boxes[static_cast<std::size_t>(leaf)];
        return leafBox.low[axis] + leafBox.high[axis];
    };
    const std::size_t half = order.size() / 2;
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                     [&](int a, int b) { return middleOf(a) < middleOf(b); });
    box.patch = -1;
    box.first = addBox(boxes, order.first(half));
    box.second = addBox(boxes, order.subspan(half));
    boxes.push_back(box);
    return static_cast<int>(boxes.size()) - 1;
}

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

/// Told by more positions than a polynomial of this degree has zeros, in every patch.
void NurbsSurface::findClosedEdges() {
    const double same = kSameControlPoint * scale_;
    closed_ = {true, true};
    collapsed_ = {true, true, true, true};
    for (int edge = kLowU; edge <= kHighV; ++edge) {
        const std::vector<double>& breaks = isAlongU(edge) ? breaksU_ : breaksV_;
        for (std::size_t span = 0; span + 1 < breaks.size(); ++span) {
            constexpr int kPositions = 2 * kMaxDegree + 1;
            for (int i = 0; i <= kPositions; ++i) {
                const double along =
                    std::lerp(breaks[span], breaks[span + 1], static_cast<double>(i) / kPositions);
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
    constexpr int kPositions = 5;
    if (hasCrease()) {
        concavity_ = kCrease;
        return;
    }
    double largest = 0.0;
    for (const NurbsPatch& patch : patches_) {
        for (int i = 0; i < kPositions; ++i) {
            const double u = std::lerp(patch.lowU, patch.highU, (i + 0.5) / kPositions);
            for (int j = 0; j < kPositions; ++j) {
                const double v = std::lerp(patch.lowV, patch.highV, (j + 0.5) / kPositions);
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

/// Returns whether the tangent planes of two patches differ where these meet.
bool NurbsSurface::hasCrease() const noexcept {
    constexpr int kPositions = 3;
    constexpr double kAside = 1e-9;  // of the parameters' range
    const auto bendsBetween = [this](double u0, double v0, double u1, double v1) {
        return (normal(u0, v0) - normal(u1, v1)).norm() > kSharp;
    };
    for (const NurbsPatch& patch : patches_) {
        for (int i = 0; i < kPositions; ++i) {
            const double share = (i + 0.5) / kPositions;
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

/// The collapsed edge beside which the position lies, or -1.
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
/// integral of Suv; Gauss's rule with two positions is exact to the third order of the distance.
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
        const double position = 0.125 * i;
        const ParametricSample s = isAlongU(edge) ? at(position, across) : at(across, position);
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

NurbsDecomposition decomposed(const NurbsSurface::Net& net) {
    const KnotAxis u{net.knotsU, net.degreeU};
    const KnotAxis v{net.knotsV, net.degreeV};
    check(u, "u");
    check(v, "v");
    checkPoints(net, static_cast<std::size_t>(u.controls()) * v.controls());
    NurbsDecomposition result{.breaksU = breaksOf(u), .breaksV = breaksOf(v), .patches = {}};
    const std::vector<std::size_t> spansU = spansOf(u);
    const std::vector<std::size_t> spansV = spansOf(v);
    for (std::size_t j = 0; j < spansV.size(); ++j) {
        for (std::size_t i = 0; i < spansU.size(); ++i) {
            result.patches.push_back({.net = bezierNet(net, spansU[i], spansV[j]),
                                      .lowU = result.breaksU[i],
                                      .highU = result.breaksU[i + 1],
                                      .lowV = result.breaksV[j],
                                      .highV = result.breaksV[j + 1]});
        }
    }
    return result;
}

std::vector<PatchBox> boxTree(const std::vector<NurbsPatch>& patches) {
    std::vector<PatchBox> boxes;
    boxes.reserve(2 * patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        boxes.push_back(boxOf(patches[i].net, static_cast<int>(i)));
    }
    std::vector<int> order(patches.size());
    std::iota(order.begin(), order.end(), 0);
    addBox(boxes, order);
    return boxes;
}

}  // namespace asperity
