#include "core/haptics/DevicePath.h"

#include "core/scene/SampleMaterials.h"
#include "core/scene/Scene.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/deformation/ContactHeight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kFeatureMargin = 0.03;  // of the scan's width, kept free at each edge
constexpr double kSlideDirection = std::numbers::pi / 3.0;  // so that both signals take part [rad]
constexpr int kRasterLines = 8;

/// The base must rise by more than the lever holds back before the tip lets go.
double clearanceFor(const Scene& scene, const PathPlan& plan) {
    const Cantilever& cantilever = scene.belief.cantilever;
    const double compliance = cantilever.compliance()(2, 2);
    const double pullOff =
        std::max(std::abs(scene.belief.contact.pullOffApproach(compliance)),
                 std::abs(softestContact(scene.belief).pullOffApproach(compliance)));
    return std::max(plan.clearance, plan.clearance + 1.5 * pullOff);
}

/// Between points of a path in contact [m]: fine enough for the lattice of a scan under a sharp
/// tip; a blunt one touches no detail that is much finer than itself.
double stepFor(const Scene& scene) { return std::max(0.5e-9, scene.description.tip.radius / 30.0); }

/// Keeps a coordinate inside the scan.
double inside(double coordinate, double size) {
    return std::clamp(coordinate, 0.02 * size, 0.98 * size);
}

Vector2 featureFor(const Scene& scene, const PathPlan& plan) {
    if (plan.position) {
        return {inside(plan.position->x(), scene.surface.sizeX()),
                inside(plan.position->y(), scene.surface.sizeY())};
    }
    const SurfacePoint top = highestPoint(scene.surface, kFeatureMargin);
    return {top.x, top.y};
}

/// Builds a path in phases, each given as a share of the whole duration.
class PathBuilder {
public:
    PathBuilder(const Scene& scene, const PathPlan& plan, const Vector3& start)
        : scene_(scene), duration_(plan.duration), path_{{0.0, start}} {}

    void moveTo(const Vector3& target, double share) {
        append(path_.back().time + share * duration_, target);
    }

    void hold(double share) { moveTo(path_.back().position, share); }

    /// Follows the surface in a straight line seen from above, from the present depth below touch
    /// to `endDepth`.
    void follow(double x, double y, double endDepth, double share) {
        const PathPoint from = path_.back();
        const double startDepth =
            touchHeight(scene_, from.position.x(), from.position.y()) - from.position.z();
        const double length = std::hypot(x - from.position.x(), y - from.position.y());
        const int steps = std::max(1, static_cast<int>(std::ceil(length / stepFor(scene_))));
        for (int i = 1; i <= steps; ++i) {
            const double s = static_cast<double>(i) / steps;
            const double px = std::lerp(from.position.x(), x, s);
            const double py = std::lerp(from.position.y(), y, s);
            const double depth = std::lerp(startDepth, endDepth, s);
            append(from.time + s * share * duration_,
                   {px, py, touchHeight(scene_, px, py) - depth});
        }
    }

    [[nodiscard]] const Vector3& position() const { return path_.back().position; }
    [[nodiscard]] DevicePath take() { return std::move(path_); }

private:
    void append(double time, const Vector3& position) { path_.push_back({time, position}); }

    const Scene& scene_;
    double duration_;
    DevicePath path_;
};

Vector3 above(const Scene& scene, double x, double y, double height) {
    return {x, y, touchHeight(scene, x, y) + height};
}

constexpr double kShare = 0.25;               // of the height that one notch takes, far away
constexpr double kOfHalfWidth = 1.0 / 400.0;  // 0.1 nm in a view of 80 nm
constexpr double kOfSetpoint = 0.2;
constexpr double kAlwaysFine = 0.1e-9;  // [m]

}  // namespace

Vector3 positionAt(const DevicePath& path, double time) {
    const auto next =
        std::upper_bound(path.begin(), path.end(), time,
                         [](double value, const PathPoint& point) { return value < point.time; });
    if (next == path.begin()) {
        return path.front().position;
    }
    if (next == path.end()) {
        return path.back().position;
    }
    const PathPoint& before = *(next - 1);
    const double share = (time - before.time) / (next->time - before.time);
    return before.position + share * (next->position - before.position);
}

double touchHeight(const Scene& scene, double x, double y) {
    const double radius = scene.description.tip.radius;
    return tipContactHeight(scene.surface, x, y, radius) - radius;
}

Vector3 pathStart(const Scene& scene, const PathPlan& plan) {
    const Vector2 position = featureFor(scene, plan);
    return above(scene, position.x(), position.y(), clearanceFor(scene, plan));
}

DevicePath slidePath(const Scene& scene, const PathPlan& plan) {
    const Vector3 start = pathStart(scene, plan);
    const Vector2 top = start.head<2>();
    const double clearance = clearanceFor(scene, plan);
    PathBuilder path(scene, plan, start);
    path.moveTo(above(scene, top.x(), top.y(), -plan.indentation), 0.3);
    path.hold(0.05);
    const double endX =
        inside(top.x() + plan.slideLength * std::cos(kSlideDirection), scene.surface.sizeX());
    const double endY =
        inside(top.y() + plan.slideLength * std::sin(kSlideDirection), scene.surface.sizeY());
    path.follow(endX, endY, plan.indentation, 0.3);
    path.hold(0.05);
    path.moveTo(above(scene, endX, endY, clearance), 0.3);
    return path.take();
}

DevicePath rasterPath(const Scene& scene, const PathPlan& plan) {
    const Vector2 top = featureFor(scene, plan);
    const double half = 0.5 * plan.slideLength;
    const double left = inside(top.x() - half, scene.surface.sizeX());
    const double right = inside(top.x() + half, scene.surface.sizeX());
    const double bottom = inside(top.y() - half, scene.surface.sizeY());
    const double pitch = plan.slideLength / (kRasterLines - 1);
    const double clearance = clearanceFor(scene, plan);
    PathBuilder path(scene, plan, above(scene, left, bottom, clearance));
    path.moveTo(above(scene, left, bottom, -plan.indentation), 0.1);
    constexpr double kLineShare = 0.8 / (2 * kRasterLines - 1);
    for (int line = 0; line < kRasterLines; ++line) {
        const double y = inside(bottom + line * pitch, scene.surface.sizeY());
        if (line > 0) {
            path.follow(path.position().x(), y, plan.indentation, kLineShare);
        }
        path.follow(line % 2 == 0 ? right : left, y, plan.indentation, kLineShare);
    }
    const Vector3 end = path.position();
    path.moveTo(above(scene, end.x(), end.y(), clearance), 0.1);
    return path.take();
}

DevicePath scratchPath(const Scene& scene, const PathPlan& plan) {
    const double length = std::min(5.0 * plan.slideLength, 0.8 * scene.surface.sizeX());
    const Vector2 middle =
        plan.position.value_or(0.5 * Vector2(scene.surface.sizeX(), scene.surface.sizeY()));
    const Vector2 asked(std::clamp(middle.x() - 0.5 * length, 0.02 * scene.surface.sizeX(),
                                   0.98 * scene.surface.sizeX() - length),
                        inside(middle.y(), scene.surface.sizeY()));
    const Vector2 start = plan.position ? asked : nearestMeasured(scene.surface, asked);
    const double endX = std::min(start.x() + length, 0.98 * scene.surface.sizeX());
    const double clearance = clearanceFor(scene, plan);
    PathBuilder path(scene, plan, above(scene, start.x(), start.y(), clearance));
    path.moveTo(above(scene, start.x(), start.y(), 0.0), 0.15);
    path.follow(endX, start.y(), 2.0 * plan.indentation, 0.6);
    path.moveTo(above(scene, endX, start.y(), clearance), 0.25);
    return path.take();
}

DevicePath linesPath(const Vector3& from, const LinesPlan& plan) {
    const Vector3 along(std::cos(plan.direction), std::sin(plan.direction), 0.0);
    const Vector3 across = Vector3::UnitZ().cross(along);
    DevicePath path{{0.0, from}};
    const auto moveTo = [&](const Vector3& to) {
        const double way = (to - path.back().position).norm();
        if (way > 0.0) {
            path.push_back({path.back().time + way / plan.speed, to});
        }
    };
    for (int line = 0; line < plan.lines; ++line) {
        const Vector3 start = from + line * plan.pitch * across;
        moveTo(start);
        moveTo(start + plan.length * along);
        moveTo(start);
    }
    return path;
}

Vector3 waitingPosition(const Scene& scene, const Vector2& position) {
    return above(scene, position.x(), position.y(), clearanceFor(scene, {}));
}

DevicePath journey(const Scene& scene, const Vector3& from, const Vector2& to, double duration) {
    const Vector3 end = waitingPosition(scene, to);
    const Vector2 way = to - from.head<2>();
    const int steps = 1 + static_cast<int>(way.norm() / scene.description.tip.radius);
    double height = std::max(from.z(), end.z());
    for (int i = 0; i <= steps; ++i) {
        const Vector2 position = from.head<2>() + i * way / steps;
        height = std::max(height, waitingPosition(scene, position).z());
    }
    PathBuilder path(scene, {.duration = duration}, from);
    path.moveTo({from.x(), from.y(), height}, 0.3);
    path.moveTo({end.x(), end.y(), height}, 0.4);
    path.moveTo(end, 0.3);
    return path.take();
}

ScriptedDevice::ScriptedDevice(DevicePath path, double positionGain)
    : path_(std::move(path))
    , positionGain_(positionGain)
    , start_(path_.front().position / positionGain) {}

ScriptedDevice::ScriptedDevice(DevicePath path, double positionGain, Vector3 start)
    : path_(std::move(path)), positionGain_(positionGain), start_(std::move(start)) {}

DeviceState ScriptedDevice::advance(double timeStep) noexcept {
    if (started_) {
        time_ += timeStep;
    }
    started_ = true;
    const Vector3 way = positionAt(path_, time_) - path_.front().position;
    return {.position = start_ + way / positionGain_};
}

void DevicePilot::displace(const Vector3& displacement) {
    journey_.clear();
    target_ += displacement;
}

void DevicePilot::setVelocity(const Vector3& velocity) {
    if (!velocity.isZero()) {
        journey_.clear();
    }
    velocity_ = velocity;
}

void DevicePilot::follow(DevicePath journey) {
    journey_ = std::move(journey);
    journeyTime_ = journey_.front().time;
}

void DevicePilot::keepNear(const Vector3& position, double most) {
    const Vector2 ahead = (target_ - position).head<2>();
    if (ahead.norm() > most) {
        target_.head<2>() = position.head<2>() + most / ahead.norm() * ahead;
    }
}

Vector3 DevicePilot::advance(double seconds, const DeviceMapping& mapping) {
    target_ += seconds * velocity_;
    if (traveling()) {
        journeyTime_ += seconds;
        target_ = mapping.deviceFor(positionAt(journey_, journeyTime_));
        if (journeyTime_ >= journey_.back().time) {
            journey_.clear();
        }
    }
    return target_;
}

// Counted in notches from the sample the height is linear up to fineStep / kShare, where a notch is
// that share of it, and exponential from there on: step and slope are continuous.
double liftedHeight(double height, double notches, double fineStep) noexcept {
    constexpr double kBendNotches = 1.0 / kShare;
    const double bend = kBendNotches * fineStep;
    const double from =
        height <= bend ? height / fineStep : kBendNotches * (1.0 + std::log(height / bend));
    const double to = from + notches;
    return to <= kBendNotches ? to * fineStep : bend * std::exp(to / kBendNotches - 1.0);
}

double fineLiftStep(double halfWidth, double setpoint, double stiffness) noexcept {
    return std::min(kOfHalfWidth * halfWidth,
                    std::max(kAlwaysFine, kOfSetpoint * setpoint / stiffness));
}

}  // namespace asperity
