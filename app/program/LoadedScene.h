#pragma once

#include "core/fidelity/RequiredTerms.h"
#include "core/scene/Scene.h"
#include "core/surface/Provenance.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

class AfmController;

/// A scene with what is known of the file that it was loaded from (app/loading/SceneLoader.h).
struct LoadedScene {
    Scene scene;
    std::string format;              ///< of the height map, for people; "shape" without one
    std::string sha256;              ///< of the height map's file; empty without one
    std::vector<std::string> notes;  ///< on the heights, a sentence each: of reader and leveling
    std::vector<Provenance> provenance;      ///< sources of scale and orientation of the heights
    RequiredTerms needs;                     ///< why the scene's model is what it is
    std::vector<std::string> images = {};    ///< of the file, others with the scan's pixels
    std::vector<std::string> channels = {};  ///< of the file, those that can be taken instead
    std::size_t filledPixels = 0;            ///< of the map as loaded that held no data
    double originX = 0.0;  ///< lower left corner of the scan in the instrument's frame [m]
    double originY = 0.0;  ///< its y [m]
};

/// All that was decided about a scene: its notes, and those on the force.
[[nodiscard]] std::vector<std::string> notesOn(const LoadedScene& loaded);

/// All that is known of the scan that a scene has, and what was done to it: file, format,
/// hash, channel, pixels, crop, leveling, notes, and where the numbers come from. Lines of text for
/// people; what is quoted from the file is printable.
[[nodiscard]] std::string scanReport(const LoadedScene& loaded);

/// The instrument of a scene, which outlives it, in the window and in `explore`: as the scene's
/// [truth] says, a simulated AFM that answers at once, or one that plays a recorded curve.
[[nodiscard]] std::unique_ptr<AfmController> instrumentOf(const Scene& scene);

}  // namespace asperity
