#include "tests/support/HeldLine.h"

#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <memory>
#include <utility>

namespace asperity::test {

HeldLine heldLine(const Scene& scene, const Vector2& position, const LinesPlan& lines,
                  double setpoint) {
    constexpr double kSettling = 0.5;  // [s]
    const double stiffness = 1.0 / scene.belief.cantilever.compliance()(2, 2);
    const double touch = touchHeight(scene, position.x(), position.y());
    const Vector3 base(position.x(), position.y(), touch - setpoint / stiffness);
    DevicePath path = linesPath(base, lines);
    for (PathPoint& point : path) {
        point.time += kSettling;
    }
    const double duration = path.back().time;
    FeedbackDevice device(
        std::make_unique<ScriptedDevice>(std::move(path), scene.settings.positionGain),
        planFeedback(scene, base, setpoint, 0.0), base.z(), scene.settings.positionGain);
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    HeldLine held;
    runVirtually(scene, device, afm, 1 + static_cast<long>(duration / scene.timeStep()),
                 [&](const TickSample& sample) {
                     held.all.push_back(sample);
                     if (sample.time >= kSettling) {
                         held.samples.push_back(sample);
                     }
                 });
    held.state = device.state();
    return held;
}

}  // namespace asperity::test
