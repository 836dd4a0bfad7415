#include "tests/ui/view/ViewMoments.h"

#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "tests/support/TestScenes.h"

#include <optional>

namespace asperity::test {

ViewMoments momentsOf(const Scene& scene, double indentation) {
    const PathPlan plan{.duration = 4.0, .indentation = indentation, .slideLength = 0.0};
    SimulatedAfm afm(scene.surface, truthOf(scene));
    RunEventRecorder recorder;
    std::optional<TickSample> first;
    runVirtually(scene, slidePath(scene, plan), afm, 4000, [&](const TickSample& sample) {
        recorder.take(sample);
        if (!first) {
            first = sample;
        }
    });
    ViewMoments moments;
    moments.away.sample = first.value();
    moments.deep.sample = recorder.events().deepest.value();
    moments.neck.sample = recorder.events().beforePullOff.value();
    return moments;
}

Snapshot movedBy(Snapshot snapshot, const Vector3& way) {
    TipState& state = snapshot.sample.output.model;
    state.tip += way;
    state.closest.point += Vector3(way.x(), way.y(), 0.0);
    state.contact.indentation -= way.z();
    return snapshot;
}

Scene flatScene() { return buildScene(plainScene(), flatMap()); }

Scene hillyScene() { return buildScene(plainScene(), hillyMap()); }

}  // namespace asperity::test
