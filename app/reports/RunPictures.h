#pragma once

#include "app/charts/Chart.h"
#include "core/Progress.h"
#include "core/Vector.h"
#include "core/haptics/VirtualRun.h"
#include "vtkplugins/pictures/DeformationPicture.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Collects what the plots of a run show; SI units.
class RunCurves {
public:
    void take(const TickSample& sample);

    /// Forces, approach and retract, contact, and signals.
    [[nodiscard]] std::vector<Chart> charts() const;
    /// Draws them as forces.png. There is a QGuiApplication. @throw Error
    void write(const std::filesystem::path& path) const;

    /// Returns the path of the tip's apex [m].
    [[nodiscard]] const std::vector<Vector3>& tipPath() const noexcept { return tip_; }

private:
    /// One leg of a force-distance curve.
    struct Leg {
        std::vector<double> height;  ///< of the base above first touch [m]
        std::vector<double> force;   ///< along z [N]
    };

    void takeLegs(const TickSample& sample);

    std::vector<double> time_;           ///< [s]
    std::vector<Vector3> tip_;           ///< apex [m]
    std::vector<Vector3> estimate_;      ///< force from the signals [N]
    std::vector<Vector3> model_;         ///< model force [N]
    std::vector<double> indentation_;    ///< [m]
    std::vector<double> contactRadius_;  ///< [m]
    std::vector<double> bending_;        ///< [rad]
    std::vector<double> torsion_;        ///< [rad]
    Leg approach_;
    Leg retract_;
};

struct Scene;

/// Pictures of a run, ready to be drawn. Drawing takes as much memory as a large scan: the scene
/// may be deleted before it.
class RunPictures {
public:
    RunPictures(const Scene& scene, const RunEvents& events);

    /// Draws into `folder`: deformation.png (largest indentation, and the adhesion neck where there
    /// was one), overview.png, forces.png; and writes deformation.exr, the deformed surface at the
    /// largest indentation. @throw Error; Canceled
    void write(const std::filesystem::path& folder, const RunCurves& curves,
               Progress* progress) const;

    /// Draws the deformation at the largest indentation, and the adhesion neck where there was one.
    /// @throw Error
    void writeDeformation(const std::filesystem::path& path, PictureSize size = {}) const;
    /// Draws the whole scan. @param tipPath of the tip's apex [m] @throw Error
    void writeOverview(const std::filesystem::path& path, const std::vector<Vector3>& tipPath,
                       PictureSize size = {}) const;

private:
    std::string name_;  ///< of the sample
    TickSample deepest_;
    std::vector<DeformationView> deformation_;
    SurfacePatch deepestPatch_;  ///< data, not a picture: with the rim as sharp as it is
    BSplineSurface surface_;
    ScanWindow zoom_;
};

struct Scene;

/// The patch around the tip that pictures of a moment show: as wide as the scene says, or else as
/// the surface that visibly follows the tip.
[[nodiscard]] PatchGrid zoomGrid(const Scene& scene, const TickSample& sample);

/// The deformed surface that these pictures show; files hold the same.
[[nodiscard]] SurfacePatch zoomPatch(const Scene& scene, const TickSample& sample);

/// The same of another patch.
[[nodiscard]] SurfacePatch zoomPatch(const Scene& scene, const TickSample& sample,
                                     const PatchGrid& grid);

/// A moment of a run as the deformation picture shows it, deformed as the scene says.
[[nodiscard]] DeformationView contactView(const Scene& scene, const TickSample& sample,
                                          const std::string& title);
/// The same of another patch.
[[nodiscard]] DeformationView contactView(const Scene& scene, const TickSample& sample,
                                          const std::string& title, const PatchGrid& grid);

}  // namespace asperity
