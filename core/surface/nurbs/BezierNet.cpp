#include "core/surface/nurbs/BezierNet.h"

#include <algorithm>

namespace asperity {

namespace {

using Along = std::array<double, BezierNet::kMaxAlong>;

/// Bernstein polynomials of one degree and their first two derivatives.
struct BernsteinBasis {
    Along value{};
    Along slope{};
    Along curvature{};
};

/// From the polynomials of a degree to those of the next one.
void raise(Along& basis, int degree, double t) {
    for (int i = degree + 1; i >= 0; --i) {
        const double same = i <= degree ? basis[i] : 0.0;
        const double before = i > 0 ? basis[i - 1] : 0.0;
        basis[i] = (1.0 - t) * same + t * before;
    }
}

/// The derivative of sum c_i B_i is degree times the sum of (c_i+1 - c_i) B_i of a degree less.
Along derivative(const Along& lower, int degree) {
    Along basis{};
    for (int i = 0; i <= degree; ++i) {
        const double before = i > 0 ? lower[i - 1] : 0.0;
        const double same = i < degree ? lower[i] : 0.0;
        basis[i] = degree * (before - same);
    }
    return basis;
}

BernsteinBasis bernsteinBasis(int degree, double t) {
    BernsteinBasis basis;
    Along lower{};
    lower[0] = 1.0;
    for (int d = 0; d < degree; ++d) {
        if (d == degree - 2) {
            basis.curvature = derivative(derivative(lower, degree - 1), degree);
        }
        if (d == degree - 1) {
            basis.slope = derivative(lower, degree);
        }
        raise(lower, d, t);
    }
    basis.value = lower;
    return basis;
}

/// Quotient rule, order by order: A = w S.
ParametricSample divided(const HomogeneousPoint& a, const std::array<HomogeneousPoint, 5>& d) {
    const auto& [u, v, uu, uv, vv] = d;
    const double w = a[3];
    ParametricSample s;
    s.point = a.head<3>() / w;
    s.du = (u.head<3>() - u[3] * s.point) / w;
    s.dv = (v.head<3>() - v[3] * s.point) / w;
    s.duu = (uu.head<3>() - 2.0 * u[3] * s.du - uu[3] * s.point) / w;
    s.duv = (uv.head<3>() - u[3] * s.dv - v[3] * s.du - uv[3] * s.point) / w;
    s.dvv = (vv.head<3>() - 2.0 * v[3] * s.dv - vv[3] * s.point) / w;
    return s;
}

/// Cuts one row of control points at its middle by de Casteljau's rule; `stride` apart.
void halve(const HomogeneousPoint* from, int degree, std::size_t stride, HomogeneousPoint* low,
           HomogeneousPoint* high) {
    std::array<HomogeneousPoint, BezierNet::kMaxAlong> row;
    for (int i = 0; i <= degree; ++i) {
        row[i] = from[i * stride];
    }
    for (int level = 0; level <= degree; ++level) {
        low[level * stride] = row[0];
        high[(degree - level) * stride] = row[degree - level];
        for (int i = 0; i < degree - level; ++i) {
            row[i] = 0.5 * (row[i] + row[i + 1]);
        }
    }
}

}  // namespace

ParametricSample BezierNet::sample(double u, double v) const noexcept {
    const BernsteinBasis inU = bernsteinBasis(degreeU, u);
    const BernsteinBasis inV = bernsteinBasis(degreeV, v);
    HomogeneousPoint value = HomogeneousPoint::Zero();
    std::array<HomogeneousPoint, 5> derivatives;
    derivatives.fill(HomogeneousPoint::Zero());
    for (int j = 0; j <= degreeV; ++j) {
        HomogeneousPoint row = HomogeneousPoint::Zero();
        HomogeneousPoint rowSlope = HomogeneousPoint::Zero();
        HomogeneousPoint rowCurvature = HomogeneousPoint::Zero();
        for (int i = 0; i <= degreeU; ++i) {
            row += inU.value[i] * at(i, j);
            rowSlope += inU.slope[i] * at(i, j);
            rowCurvature += inU.curvature[i] * at(i, j);
        }
        value += inV.value[j] * row;
        derivatives[0] += inV.value[j] * rowSlope;
        derivatives[1] += inV.slope[j] * row;
        derivatives[2] += inV.value[j] * rowCurvature;
        derivatives[3] += inV.slope[j] * rowSlope;
        derivatives[4] += inV.curvature[j] * row;
    }
    return divided(value, derivatives);
}

BezierNet BezierNet::seenFrom(const Vector3& origin) const noexcept {
    BezierNet moved;
    moved.degreeU = degreeU;
    moved.degreeV = degreeV;
    for (int j = 0; j <= degreeV; ++j) {
        for (int i = 0; i <= degreeU; ++i) {
            const double weight = at(i, j)[3];
            moved.at(i, j) << at(i, j).head<3>() - weight * origin, weight;
        }
    }
    return moved;
}

BezierHalves halvedAlongU(const BezierNet& net) noexcept {
    BezierHalves halves;
    halves.low.degreeU = halves.high.degreeU = net.degreeU;
    halves.low.degreeV = halves.high.degreeV = net.degreeV;
    for (int j = 0; j <= net.degreeV; ++j) {
        halve(&net.at(0, j), net.degreeU, 1, &halves.low.at(0, j), &halves.high.at(0, j));
    }
    return halves;
}

BezierHalves halvedAlongV(const BezierNet& net) noexcept {
    BezierHalves halves;
    halves.low.degreeU = halves.high.degreeU = net.degreeU;
    halves.low.degreeV = halves.high.degreeV = net.degreeV;
    for (int i = 0; i <= net.degreeU; ++i) {
        halve(&net.at(i, 0), net.degreeV, BezierNet::kMaxAlong, &halves.low.at(i, 0),
              &halves.high.at(i, 0));
    }
    return halves;
}

}  // namespace asperity
