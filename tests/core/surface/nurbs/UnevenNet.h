#pragma once

#include "core/surface/nurbs/NurbsSurface.h"

namespace asperity::test {

struct WeightedPoint {
    Vector3 point;  ///< [m]
    double weight = 1.0;
};

/// Of degree 3 by 2 with 7 x 5 points, repeated and uneven knots.
/// @param pointAt (i, j): along u and v; called row by row along u
template <class PointAt>
NurbsSurface::Net unevenNet(const PointAt& pointAt) {
    NurbsSurface::Net net{.degreeU = 3,
                          .degreeV = 2,
                          .knotsU = {0.0, 0.0, 0.0, 0.0, 0.3, 0.6, 0.6, 1.0, 1.0, 1.0, 1.0},
                          .knotsV = {-1.0, 0.0, 1.0, 2.0, 2.5, 4.0, 5.0, 7.0},
                          .points = {},
                          .weights = {}};
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 7; ++i) {
            const WeightedPoint one = pointAt(i, j);
            net.points.push_back(one.point);
            net.weights.push_back(one.weight);
        }
    }
    return net;
}

}  // namespace asperity::test
