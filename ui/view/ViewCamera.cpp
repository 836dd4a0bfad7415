#include "ui/view/ViewCamera.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kMinElevation = 0.2;  // [rad]
constexpr double kMaxElevation = 1.5;  // [rad]; below pi/2: the view's top stays told

constexpr double kRightAngle = 0.5 * std::numbers::pi;
constexpr double kEdgeOn = 0.02;  // sine of the elevation below which the surface is seen edge-on

constexpr double kViewAngle = 30.0;  // of a view with perspective, from top to bottom [degree]

constexpr double kCameraMargin = 1.04;
constexpr double kTipShare = 0.15;  // where the tip mostly is, of the way to the far corner
constexpr double kDepth = 8.0;      // seen before and behind the middle, in sizes of the frame

// In half widths of the frame.
constexpr double kBlockDepth = 0.12;
constexpr double kMinFloor = 0.05;  // of block below a dent

constexpr double kExtentStep = 1.5;  // a dent that needs more room gets so many times its depth

}  // namespace

WordRoom wordRoom(double width, double height) {
    constexpr double kLine = 18.0;     // under the frame [px]
    constexpr double kWord = 45.0;     // beside it, "y (nm)" [px]
    constexpr double kMostly = 0.125;  // a view hardly larger than its words
    return {.under = std::min(kMostly, kLine / height), .beside = std::min(kMostly, kWord / width)};
}

void ViewCamera::turn(double azimuth, double elevation) {
    azimuth_ = std::remainder(azimuth_ + azimuth, 2.0 * std::numbers::pi);
    // A view from the front or straight from above turns on from there.
    elevation_ = std::clamp(elevation_ + elevation, std::min(kMinElevation, elevation_),
                            std::max(kMaxElevation, elevation_));
}

void ViewCamera::setDirection(double azimuth, double elevation) {
    azimuth_ = std::remainder(azimuth, 2.0 * std::numbers::pi);
    elevation_ = std::clamp(elevation, -kRightAngle, kRightAngle);
}

void ViewCamera::lookFrom(ViewDirection side) {
    elevation_ = side == ViewDirection::Top      ? kRightAngle
                 : side == ViewDirection::Bottom ? -kRightAngle
                                                 : 0.0;
    switch (side) {
    case ViewDirection::Right:
        azimuth_ = 0.0;
        break;
    case ViewDirection::Back:
        azimuth_ = kRightAngle;
        break;
    case ViewDirection::Left:
        azimuth_ = std::numbers::pi;
        break;
    case ViewDirection::Front:
    case ViewDirection::Top:
    case ViewDirection::Bottom:  // x stays to the right
        azimuth_ = -kRightAngle;
        break;
    }
}

Vector3 ViewCamera::out() const {
    return {std::cos(elevation_) * std::cos(azimuth_), std::cos(elevation_) * std::sin(azimuth_),
            std::sin(elevation_)};
}

Vector3 ViewCamera::right() const { return {-std::sin(azimuth_), std::cos(azimuth_), 0.0}; }

Vector3 ViewCamera::up() const { return out().cross(right()); }

double ViewCamera::heightSeen() const {
    const double seen = std::abs(std::cos(elevation_));
    return seen > kEdgeOn ? seen : 0.0;
}

void ViewCamera::apply(vtkCamera* camera, const FrameBox& box, double aspect,
                       const WordRoom& words) const {
    // The frame's corners come anywhere on a circle as the eye goes round.
    const double corner = std::numbers::sqrt2 * box.halfWidth;
    const double sine = std::abs(std::sin(elevation_));
    const double cosine = std::cos(elevation_);
    const double below = corner * sine + box.below * cosine;
    const double above = std::max(corner * sine + box.above * cosine,
                                  kTipShare * corner * sine + box.tipTop * cosine);
    const double halfHeight =
        kCameraMargin * std::max(corner / (aspect * (1.0 - 2.0 * words.beside)),
                                 0.5 * (below + above) / (1.0 - words.under));
    const double free =
        halfHeight - 0.5 * kCameraMargin * (below + above);  // under the frame, if centered
    const double raised = std::max(0.0, 2.0 * words.under * halfHeight - free);
    const Vector3 focus = box.middle + (0.5 * (above - below) - raised) * up();
    const double depth = kDepth * (box.halfWidth + box.below + box.above);
    camera->SetParallelProjection(perspective_ ? 0 : 1);
    camera->SetViewAngle(kViewAngle);
    camera->SetParallelScale(halfHeight);  // with perspective: as at the focal point
    camera->SetFocalPoint(focus.data());
    camera->SetViewUp(up().data());
    if (perspective_) {
        const double distance = halfHeight / std::tan(kViewAngle * std::numbers::pi / 360.0);
        camera->SetPosition(Vector3(focus + distance * out()).data());
        camera->SetClippingRange(0.02 * distance, distance + depth);
    } else {
        camera->SetPosition(Vector3(focus + depth * out()).data());
        camera->SetClippingRange(0.01 * depth, 2.0 * depth);
    }
}

Vector3 ViewCamera::horizontalMove(double rightwards, double upwards) const {
    // Away from the eye on the ground is up in the view, shortened by the sine of the elevation.
    const Vector3 away(-std::cos(azimuth_), -std::sin(azimuth_), 0.0);
    const double sine = std::sin(elevation_);
    if (std::abs(sine) < kEdgeOn) {
        return rightwards * right();
    }
    return rightwards * right() + upwards / sine * away;
}

void ViewExtent::fit(const FramedSurface& surface, double tipHeight, double dent) {
    const double slack = (kBlockDepth - kMinFloor) * surface.halfWidth / surface.heightScale;
    usualDent_ = dent > slack ? dent : 0.0;  // the block has room for a shallow one anyway
    dentDepth_ = std::max(dentDepth_, usualDent_);
    const double above = surface.heightScale * surface.heights.high - surface.middle();
    fitted_ = {.halfWidth = surface.halfWidth,
               .below = surface.middle() - drawnBottom(surface),
               .above = above,
               .tipTop = above + tipHeight};
    isFitWanted_ = false;
}

void ViewExtent::forget() {
    dentDepth_ = 0.0;
    lowered_ = 0.0;
    isFitWanted_ = true;
}

/// It does not shrink as long as the tip touches.
bool ViewExtent::makeRoomFor(double lowest, const FramedSurface& surface) {
    const double floor = kMinFloor * surface.halfWidth / surface.heightScale;
    if (!(bottom(surface) + floor > lowest)) {
        return false;
    }
    dentDepth_ = kExtentStep * (surface.heights.low - lowest);
    return true;
}

bool ViewExtent::release() {
    const bool isOther = dentDepth_ != usualDent_ || lowered_ != 0.0;
    dentDepth_ = usualDent_;
    lowered_ = 0.0;
    return isOther;
}

double ViewExtent::drawnBottom(const FramedSurface& surface) const {
    return surface.heightScale * (surface.heights.low - dentDepth_) -
           kBlockDepth * surface.halfWidth;
}

double ViewExtent::bottom(const FramedSurface& surface) const {
    return drawnBottom(surface) / surface.heightScale;
}

FrameBox ViewExtent::box(const FramedSurface& surface, const Vector2& center) const {
    FrameBox box = fitted_;
    box.middle = {center.x(), center.y(), surface.middle() - lowered_};
    return box;
}

}  // namespace asperity
