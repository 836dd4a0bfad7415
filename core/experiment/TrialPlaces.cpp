#include "core/experiment/TrialPlaces.h"

#include "core/haptics/DevicePath.h"
#include "core/scene/Scene.h"

namespace asperity {

TrialPlaces placesOf(const Study& study, const Scene& scene, const PlannedTrial& trial) {
    const Vector2 middle = 0.5 * Vector2(scene.surface.sizeX(), scene.surface.sizeY());
    const auto above = [&](const Vector2& place, double height) {
        return Vector3(place.x(), place.y(), touchHeight(scene, place.x(), place.y()) + height);
    };
    return {.start = above(middle, study.startHeight),
            .target = above(middle + study.targets.at(trial.target), trial.height)};
}

}  // namespace asperity
