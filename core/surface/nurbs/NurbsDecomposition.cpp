#include "core/surface/nurbs/NurbsDecomposition.h"

#include "core/Error.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace asperity {

namespace {

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
    /// A knot's place among 0 to 1.
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

/// Where the patches meet along one parameter: the last knot of each repeated one.
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
    PatchBox box{.low = net.place(0, 0), .high = net.place(0, 0), .patch = patch};
    for (int j = 0; j <= net.degreeV; ++j) {
        for (int i = 0; i <= net.degreeU; ++i) {
            box.low = box.low.cwiseMin(net.place(i, j));
            box.high = box.high.cwiseMax(net.place(i, j));
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
