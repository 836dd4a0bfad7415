#pragma once

#include "core/scene/SceneDescription.h"
#include "core/surface/HeightMap.h"

#include <string>
#include <vector>

namespace asperity::test {

/// A scene on a height map, and a position of it where a tip is let down.
struct ScaledScene {
    std::string name;
    SceneDescription description;
    HeightMap map;
    Vector2 position = Vector2::Zero();  ///< world [m]
    double reach = 0.0;                  ///< how far the base goes above and below first touch [m]
};

/// The same scene with all lengths, the range of cohesion, work of adhesion and stiffness `scale`
/// times as large, and its setpoint `scale` squared: elasticity then has all forces `scale` squared
/// times as large.
[[nodiscard]] ScaledScene scaled(ScaledScene scene, double scale);

/// Ten scenes without a length of their own but those that scaled() scales: flat, steep and rough
/// ground, one and several contact points, with and without adhesion and friction, stiff and soft.
[[nodiscard]] std::vector<ScaledScene> scenesWithoutLengths();

}  // namespace asperity::test
