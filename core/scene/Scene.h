#pragma once

#include "core/Progress.h"
#include "core/probe/DetectorCalibration.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/ForceModelOptions.h"
#include "core/scene/JudgedQuantity.h"
#include "core/scene/ScanSmoothing.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/Settings.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/nurbs/NurbsSurface.h"
#include "core/surface/sample/SampleSurface.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

class HeightMoments;
struct PlayedCurve;

/// The files that a description names beside its sample, as they were read.
struct SceneMaps {
    MaterialMaps sample;
    MaterialMaps truth;
    std::shared_ptr<const PlayedCurve> curve = nullptr;  ///< of the instrument; null: simulated
};

/// Everything that stays constant while the loop runs. A new scan or material is a new scene.
struct Scene {
    SceneDescription description;
    std::vector<RemovedByStep> removedBySteps;  ///< of leveling, in order
    PlaneFit removedPlane;                      ///< the sum of the planes that they removed
    BSplineSurface surface;                     ///< as drawn; the tip touches it without `shape`
    CertaintyMap certainty;                     ///< of the surface, where its imaging tip is known
    /// White noise of the scan's heights before smoothing that would leave the curvatures the noise
    /// that they have, estimated [m].
    double heightNoise = 0.0;
    /// Standard deviation of the mean curvature of the recorded surface by noise [1/m].
    double curvatureNoise = 0.0;
    std::optional<SmoothingChoice> smoothing;  ///< none: the scene file stated it, or has a shape
    std::optional<NurbsSurface> shape;         ///< what the tip touches instead of `surface`
    SceneMaps maps;                            ///< of materials and instrument
    /// Moments of the surface where the tip is blunt on it, see TipValidity.h; else null.
    std::shared_ptr<const HeightMoments> moments = nullptr;
    ForceModelOptions model;  ///< with which the believed force is computed
    /// Change of each quantity by the terms that the model leaves out, or that its law cannot have;
    /// where fitModel() has found it.
    std::optional<QuantityErrors> leftOut = std::nullopt;
    ProbeSystem belief;            ///< what the operator's side takes tip, lever and sample to be
    ProbeSystem truth;             ///< what they are inside the simulated instrument
    LeverSignals signalSigma;      ///< noise of the signals as the estimator takes it [rad]
    double normalDeviation = 0.0;  ///< of the surface normal, as the estimator takes it [rad]
    Settings settings;             ///< that a run starts with

    /// The believed surface, searched with the effort of the model; the scene must outlive it.
    [[nodiscard]] SampleSurface believedSurface() const noexcept {
        return shape ? SampleSurface(*shape) : SampleSurface(surface, model.closestPointSearch);
    }
    /// The true surface; the scene must outlive it.
    [[nodiscard]] SampleSurface trueSurface() const noexcept {
        return shape ? SampleSurface(*shape) : SampleSurface(surface);
    }
    [[nodiscard]] double timeStep() const noexcept { return 1.0 / description.tickRate; }  ///< [s]
};

/// The contact law of a system with material and effective radius of the tip's position.
[[nodiscard]] ContactModel contactModelAt(const ProbeSystem& system,
                                          const TipState& state) noexcept;
/// The same for the believed contact law.
[[nodiscard]] ContactModel contactModelAt(const Scene& scene, const TipState& state) noexcept;

/// Levels, fills, smooths, on request erodes, and fits the map, and sets up both sides of the
/// instrument. The description of the scene states the low-pass, chosen or not. In the map's
/// precision: a ScanMap is for scans that are too large for double.
/// @param maps all that the description's materials name
/// @throw Error when a value of the description is outside its range, or a map is missing; Canceled
[[nodiscard]] Scene buildScene(const SceneDescription& description, ScanMap map,
                               Progress* progress = nullptr, const SceneMaps& maps = {});
[[nodiscard]] Scene buildScene(const SceneDescription& description, HeightMap map,
                               Progress* progress = nullptr, const SceneMaps& maps = {});

/// The scene of a description whose sample is a shape.
/// @throw Error when it is none, or a value of the description is outside its range
[[nodiscard]] Scene buildScene(const SceneDescription& description, const SceneMaps& maps = {});

/// The same scan of another material. The instrument's truth goes along where it was the same as
/// what the scene said. @throw Error as buildScene()
[[nodiscard]] Scene withMaterial(Scene scene, const SampleMaterial& material);

/// A copy of the same surface under another tip, lever and material. Reads nothing but the surface
/// and the maps of its materials, which the new one may have, too. A low-pass that the description
/// leaves open is that of the surface.
/// @throw Error as buildScene()
[[nodiscard]] Scene withDescription(const Scene& scene, const SceneDescription& description);

/// Sets another model, of whose error nothing is known. @throw Error as believedSystem()
void setModel(Scene& scene, const ForceModelOptions& model);

/// Part that must be made again where a scene gets another description.
enum class SceneChange : std::uint8_t {
    None,     ///< nothing: it is the same
    Shown,    ///< nothing that acts: markers, view, setpoint, knobs that a run starts with
    Model,    ///< tip, lever, material or model, on the surface that is there
    Surface,  ///< the surface and the maps of its materials, from files or the shape
};

/// @param from of the scene that is there
[[nodiscard]] SceneChange changeBetween(const SceneDescription& from, const SceneDescription& to);

/// Gives a scene that is in use what changeBetween() calls Shown; the rest stays.
void adoptShown(SceneDescription& scene, const SceneDescription& from);

}  // namespace asperity
