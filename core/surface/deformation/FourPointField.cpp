#include "core/surface/deformation/DisplacementField.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// The control point before `place`; it and the next one are the two nearest along the axis.
int controlBefore(const SplinePatch::Axis& axis, double place) {
    const int before = static_cast<int>(std::floor((place - axis.first) / axis.spacing));
    return std::clamp(before, 0, axis.count - 2);
}

}  // namespace

DisplacementField fourPointField(const BSplineSurface& surface, const TipContact& contact) {
    SplinePatch net = netAroundContact(surface, contact, contact.contactRadius);
    const int column = controlBefore(net.x, contact.closest.x());
    const int row = controlBefore(net.y, contact.closest.y());
    std::fill(net.controls.begin(), net.controls.end(), Vector3::Zero());
    for (const int j : {row, row + 1}) {
        for (const int i : {column, column + 1}) {
            net.controls[net.index(j, i)] = -contact.indentation * contact.normal;
        }
    }
    return fieldOf(std::move(net));
}

}  // namespace asperity
