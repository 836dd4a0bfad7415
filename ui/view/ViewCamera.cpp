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

constexpr double kMargin = 1.04;
constexpr double kTipsPlace = 0.15;  // where the tip mostly is, of the way to the far corner
constexpr double kDepth = 8.0;       // seen before and behind the middle, in sizes of the frame

}  // namespace

void ViewCamera::turn(double azimuth, double elevation) {
    azimuth_ = std::remainder(azimuth_ + azimuth, 2.0 * std::numbers::pi);
    elevation_ = std::clamp(elevation_ + elevation, kMinElevation, kMaxElevation);
}

Vector3 ViewCamera::out() const {
    return {std::cos(elevation_) * std::cos(azimuth_), std::cos(elevation_) * std::sin(azimuth_),
            std::sin(elevation_)};
}

Vector3 ViewCamera::right() const { return {-std::sin(azimuth_), std::cos(azimuth_), 0.0}; }

Vector3 ViewCamera::up() const { return out().cross(right()); }

void ViewCamera::apply(vtkCamera* camera, const FrameBox& box, double aspect) const {
    // The frame's corners come anywhere on a circle as the eye goes round.
    const double corner = std::numbers::sqrt2 * box.halfWidth;
    const double sine = std::sin(elevation_);
    const double cosine = std::cos(elevation_);
    const double below = corner * sine + box.below * cosine;
    const double above = std::max(corner * sine + box.above * cosine,
                                  kTipsPlace * corner * sine + box.tipTop * cosine);
    const double halfHeight = kMargin * std::max(corner / aspect, 0.5 * (below + above));
    const Vector3 focus = box.middle + 0.5 * (above - below) * up();
    const double depth = kDepth * (box.halfWidth + box.below + box.above);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(halfHeight);
    camera->SetFocalPoint(focus.data());
    camera->SetPosition(Vector3(focus + depth * out()).data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(0.01 * depth, 2.0 * depth);
}

Vector3 ViewCamera::horizontalMove(double rightwards, double upwards) const {
    // Away from the eye on the ground is up in the view, shortened by the sine of the elevation.
    const Vector3 away(-std::cos(azimuth_), -std::sin(azimuth_), 0.0);
    return rightwards * right() + upwards / std::sin(elevation_) * away;
}

}  // namespace asperity
