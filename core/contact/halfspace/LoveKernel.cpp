#include "core/contact/halfspace/LoveKernel.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// Displacement at a corner of the rectangle x by y, times pi.
double cornerTerm(double x, double y) noexcept {
    return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

}  // namespace

double loveInfluence(int rows, int columns) noexcept {
    const double below = rows - 0.5;
    const double above = rows + 0.5;
    const double left = columns - 0.5;
    const double right = columns + 0.5;
    return ((cornerTerm(above, right) - cornerTerm(above, left)) -
            (cornerTerm(below, right) - cornerTerm(below, left))) /
           std::numbers::pi;
}

}  // namespace asperity
