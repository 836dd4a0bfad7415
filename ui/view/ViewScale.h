#pragma once

namespace asperity {

struct ContactPair;
struct Scene;

/// How large a scene is shown: as its tip, or as its contact where that is as wide as the tip. Of a
/// tip that would fill a view of the whole scan, as the asperity that it meets first.
struct ViewScale {
    double patch = 0.0;         ///< half the width of the part that can be deformed [m]
    double usual = 0.0;         ///< half the width of the frame that a scene starts with [m]
    double least = 0.0;         ///< half the width of the closest frame [m]
    double section = 0.0;       ///< half the width that a section starts with [m]
    double leastSection = 0.0;  ///< half the width of the narrowest section [m]
    double pixel = 0.0;         ///< of the scan, its longer side [m]
    /// Where contacts are about as wide as the tip, a law for paraboloids wants the tip drawn as
    /// one to this distance from its axis; 0: as a sphere [m].
    double paraboloidReach = 0.0;
    double dent = 0.0;   ///< that the setpoint makes, about [m]
    double force = 0.0;  ///< usual one, between setpoint and pull-off [N]
};

[[nodiscard]] ViewScale viewScale(const Scene& scene);

/// Contact radius without load [m]. Source: Johnson, Kendall, Roberts (1971).
[[nodiscard]] double unloadedContactRadius(const ContactPair& pair);

}  // namespace asperity
