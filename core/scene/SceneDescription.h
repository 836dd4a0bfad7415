#pragma once

#include "core/EnumTable.h"
#include "core/contact/ContactState.h"
#include "core/contact/Within.h"
#include "core/contact/laws/ContactOptions.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/DetectorCalibration.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/MaterialSources.h"
#include "core/scene/ModelChoices.h"
#include "core/scene/Settings.h"
#include "core/scene/Uncertainty.h"
#include "core/surface/GivenScale.h"
#include "core/surface/HeightMap.h"
#include "core/surface/RoundTip.h"
#include "core/surface/leveling/LevelingStep.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A named position on the sample, world frame, to travel to.
struct Marker {
    std::string name;
    double x = 0.0;  ///< [m]
    double y = 0.0;  ///< [m]

    bool operator==(const Marker&) const = default;
};

/// A sample material as the tip meets it.
struct SampleMaterial {
    std::string name = "polystyrene";
    std::string source = {};  ///< where its numbers come from, for people
    Elastic elastic{.youngsModulus = 2e9, .poissonRatio = 0.4};
    double workOfAdhesion = 0.066;  ///< w of the pair tip-sample [J/m^2]
    /// The same while a contact shrinks, of the laws of JKR [J/m^2]; 0: the same.
    double retractWork = 0.0;
    /// What the modulus has more at once than after a long time, E_1 [Pa]; 0: it does not relax.
    double relaxingModulus = 0.0;
    double relaxationTime = 0.0;  ///< of that part [s]; 0: it does not relax
    double drag = 0.0;            ///< C = 6 pi eta R^2 of tip and liquid [N s]; 0: none
    double dragOffset = 0.0;      ///< h_off: gap that the liquid keeps in contact [m]
    Friction friction{.coefficient = 0.3, .shearStrength = 0.0};
    /// Mean pressure under a plastic indent [Pa]; 0: not known, see hardnessOf().
    double hardness = 0.0;
    bool yields = true;          ///< false: an elastomer or a gel, which has no hardness
    double filmThickness = 0.0;  ///< of a film on a rigid base [m]; 0: a half-space
    /// Maps of what is not the same everywhere. Once they are read, the quantity above is the map's
    /// largest: it is that of the sample where one number must be used.
    MaterialSources maps;

    bool operator==(const SampleMaterial&) const = default;

    [[nodiscard]] bool hasTwoWorks() const noexcept {
        return workOfAdhesion > 0.0 && retractWork > workOfAdhesion;
    }
    /// Returns whether forces depend on how fast the tip moves.
    [[nodiscard]] bool dependsOnTime() const noexcept {
        return relaxingModulus > 0.0 || drag > 0.0;
    }
};

/// Shapes that a sample can have without error, instead of a height map.
enum class ShapeKind : std::uint8_t { Sphere, Cylinder, Plane };

template <>
inline constexpr auto
    kEnumTable<ShapeKind> = std::to_array<EnumRow<ShapeKind>>({{ShapeKind::Sphere, "sphere"},
                                                               {ShapeKind::Cylinder, "cylinder"},
                                                               {ShapeKind::Plane, "plane"}});

/// A shape as the sample; see shapeSurface() for where it lies.
struct ShapeDescription {
    ShapeKind kind = ShapeKind::Sphere;
    double radius = 100e-9;  ///< of a sphere or cylinder [m]
    double slope = 0.0;      ///< of a plane, along x [rad]
    double size = 100e-9;    ///< side of the square window that is looked at [m]

    bool operator==(const ShapeDescription&) const = default;
};

/// The map or shape under the tip and what is done to the map on load.
struct SampleDescription {
    std::optional<ShapeDescription> shape;  ///< none: the map of `file`
    std::string file;                       ///< height map, as resolved against the scene file
    std::string channel;                    ///< empty: the file's default channel
    GivenScale scale;                       ///< of a file that does not say its own
    std::optional<PixelRectangle> crop;     ///< the part of the map that is loaded; none: all of it
    LevelingSteps leveling{LevelingStep::Plane};
    std::optional<LevelPoints> levelPoints;  ///< positions of the step three_point
    /// Standard deviation of the Gaussian low-pass [pixel]; 0: none; without a value it is chosen,
    /// and stated, when a scene is built.
    std::optional<double> smoothingPixels;
    double smoothingLength = 0.0;   ///< above 0: it is this, instead of smoothingPixels [m]
    double imagingTipRadius = 0.0;  ///< of the tip that recorded the map [m]; 0: not known
    bool erode = false;             ///< whether that tip's shape is taken out of the map
    SampleMaterial material;

    bool operator==(const SampleDescription&) const = default;
};

struct TipDescription {
    double radius = 15e-9;                                          ///< [m]
    Elastic elastic{.youngsModulus = 169e9, .poissonRatio = 0.27};  ///< silicon
    double coneHalfAngle = 0.0;  ///< of the cone that the sphere goes on as [rad]; 0: no cone

    [[nodiscard]] RoundTip shape() const noexcept { return {radius, coneHalfAngle}; }

    bool operator==(const TipDescription&) const = default;
};

/// Properties of the real instrument; by default the same as what the scene says.
struct TruthDescription {
    SampleMaterial material;
    double stiffness = 0.0;     ///< of the lever along z [N/m]
    double signalNoise = 1e-7;  ///< standard deviation of the detector's noise in each signal [rad]
    std::uint64_t noiseSeed = 1;
    double temperature = 0.0;  ///< that shakes the lever [K]; 0: no thermal noise
    /// File of a measured curve that the instrument plays instead, as resolved against the scene
    /// file; empty: it is simulated.
    std::string curve = {};
    double curveStiffness = 0.0;  ///< of the lever that measured it, where the file has none [N/m]

    bool operator==(const TruthDescription&) const = default;
};

/// Everything that a scene file says, with defaults filled in; units SI.
struct SceneDescription {
    SampleDescription sample;
    TipDescription tip;
    CantileverGeometry probe;
    DetectorCalibration detector;
    std::string probeSource = {};  ///< where the numbers of the lever come from, for people
    double signalSigma = 1e-7;     ///< what the estimator takes each signal's noise to be [rad]
    TruthDescription truth;
    double cohesiveRange = kCohesiveRange;  ///< h0 of the Maugis laws [m]
    Meniscus meniscus;
    ModelChoices choices;
    double tolerance = 0.05;   ///< by which terms left out may change forces and the surface
    double tickRate = 1000.0;  ///< [Hz]
    /// Settings that a run starts with; scene files say those that have a key, see listSettings().
    Settings settings{
        .guide = {.stiffness = 200.0, .damping = 0.5, .forceLimit = 1.0, .captureDistance = 50e-9}};
    double setpoint = 5e-9;      ///< at which an approach ends: force along z [N]
    double zoomHalfWidth = 0.0;  ///< of the zoomed view [m]; 0: chosen from the contact
    Uncertainty uncertainty;     ///< of what all of it is based on
    std::vector<Marker> markers;

    bool operator==(const SceneDescription&) const = default;
};

inline constexpr double kMinTickRate = 100.0;    ///< [Hz]
inline constexpr double kMaxTickRate = 20000.0;  ///< [Hz]
inline constexpr double kMinSetpoint = 1e-12;    ///< [N]
inline constexpr double kMaxSetpoint = 1e-3;     ///< [N]
/// Returns whether a scene may have this setpoint [N].
[[nodiscard]] inline bool isSetpoint(double force) noexcept {
    return isWithin(force, kMinSetpoint, kMaxSetpoint);
}

/// The scene of a height map alone: polystyrene, 15 nm silicon tip, 14 N/m lever.
[[nodiscard]] SceneDescription defaultScene();

/// The scene with another material. The instrument's truth goes along where it was the same as what
/// the scene said.
[[nodiscard]] SceneDescription withMaterial(SceneDescription scene, const SampleMaterial& material);

/// Tip and a material of the scene as one pair.
[[nodiscard]] ContactPair contactPair(const SceneDescription& scene,
                                      const SampleMaterial& material);
/// Returns what else a contact with that material has.
[[nodiscard]] ContactOptions contactOptions(const SceneDescription& scene,
                                            const SampleMaterial& material);

/// @throw Error naming the key of the first value outside its range
void checkShape(const ShapeDescription& shape);

/// @throw Error naming the section and key of the first value outside its range
void checkScene(const SceneDescription& scene);

/// Calls visit(file) with the path of each file that a scene is read from: the scan, the maps of
/// its materials and the curve of its instrument. @param scene SceneDescription, const or not
template <class Scene, class Visit>
void forEachFile(Scene& scene, const Visit& visit) {
    if (!scene.sample.shape) {
        visit(scene.sample.file);
    }
    for (auto* maps : {&scene.sample.material.maps, &scene.truth.material.maps}) {
        forEachSource(*maps, [&visit](auto& source) { visit(source.file); });
    }
    if (!scene.truth.curve.empty()) {
        visit(scene.truth.curve);
    }
}

/// The scene as its user writes it: it may be opened with maps that have changed since.
[[nodiscard]] inline SceneDescription withoutHashes(SceneDescription scene) {
    for (MaterialSources* maps : {&scene.sample.material.maps, &scene.truth.material.maps}) {
        forEachSource(*maps, [](MapSource& source) { source.sha256.clear(); });
    }
    return scene;
}

/// Checks that one model can have all that the scene says of its terms.
/// @throw Error naming the first key that contradicts another, the contact law or the material
void checkTerms(const SceneDescription& scene);

}  // namespace asperity
