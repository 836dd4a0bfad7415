#pragma once

#include "app/reports/RunCurves.h"
#include "core/Progress.h"
#include "core/haptics/RunEvents.h"
#include "vtkplugins/pictures/DeformationPicture.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// What a run did, ready to be drawn. Drawing takes as much memory as a large scan: the scene may
/// go before it.
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
    /// Draws the whole scan. @param tipPath where the tip's apex went [m] @throw Error
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

}  // namespace asperity
