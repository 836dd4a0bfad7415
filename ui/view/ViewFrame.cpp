#include "ui/view/ViewFrame.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// How far inside of its slack the place lies after a step, in half widths: each step is at least
/// as long, so that there are few of them.
constexpr double kStep = 0.1;

double followed(double center, double place, double slack, double step) {
    const double offset = place - center;
    if (std::abs(offset) <= slack) {
        return center;
    }
    return place - std::copysign(slack - step, offset);
}

}  // namespace

ViewFrame::ViewFrame(double sizeX, double sizeY, double halfWidth)
    : size_(sizeX, sizeY), center_(0.5 * size_), halfWidth_(halfWidth) {
    setHalfWidth(halfWidth);
}

void ViewFrame::setHalfWidth(double halfWidth) {
    halfWidth_ = std::min(halfWidth, 0.5 * size_.maxCoeff());
    stayInside();
}

void ViewFrame::follow(const Vector2& place, double slack) {
    if ((place - center_).cwiseAbs().maxCoeff() > halfWidth_) {  // out of the picture: a new one
        center_ = place;
    }
    const double range = slack * halfWidth_;
    const double step = kStep * halfWidth_;
    center_ = {followed(center_.x(), place.x(), range, step),
               followed(center_.y(), place.y(), range, step)};
    stayInside();
}

Vector2 ViewFrame::reach() const { return (0.5 * size_).cwiseMin(halfWidth_); }

void ViewFrame::stayInside() {
    const Vector2 margin = reach();
    center_ = center_.cwiseMax(margin).cwiseMin(size_ - margin);
}

ScanWindow ViewFrame::window() const {
    const Vector2 low = center_ - reach();
    const Vector2 high = center_ + reach();
    return {.left = low.x(), .right = high.x(), .bottom = low.y(), .top = high.y()};
}

ScanWindow windowAround(const Vector2& place, double halfWidth, const ScanWindow& inside) {
    const double x = std::clamp(place.x(), inside.left, inside.right);
    const double y = std::clamp(place.y(), inside.bottom, inside.top);
    return {.left = std::max(x - halfWidth, inside.left),
            .right = std::min(x + halfWidth, inside.right),
            .bottom = std::max(y - halfWidth, inside.bottom),
            .top = std::min(y + halfWidth, inside.top)};
}

bool holds(const ScanWindow& area, const Vector2& place) {
    return place.x() >= area.left && place.x() <= area.right && place.y() >= area.bottom &&
           place.y() <= area.top;
}

bool sameWindow(const ScanWindow& one, const ScanWindow& other) {
    return one.left == other.left && one.right == other.right && one.bottom == other.bottom &&
           one.top == other.top;
}

}  // namespace asperity
