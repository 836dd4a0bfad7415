#pragma once

#include "core/scene/Scene.h"

namespace asperity {

/// How large a scene is shown: as its tip, or as its contact where that is as wide as the tip.
struct ViewScale {
    double patch = 0.0;  ///< half the width of the part that can be deformed [m]
    double usual = 0.0;  ///< half the width of the frame that a scene starts with [m]
    double least = 0.0;  ///< half the width of the closest frame [m]
};

[[nodiscard]] ViewScale viewScale(const Scene& scene);

/// Contact radius without load [m]. Source: Johnson, Kendall, Roberts (1971).
[[nodiscard]] double unloadedContactRadius(const ContactPair& pair);

}  // namespace asperity
