#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A rectangle of the scan, seen from above. World frame.
struct ScanWindow {
    double left = 0.0;    ///< smallest x [m]
    double right = 0.0;   ///< largest x [m]
    double bottom = 0.0;  ///< smallest y [m]
    double top = 0.0;     ///< largest y [m]
};

/// The whole scan and where the tip is. World frame, SI units.
struct OverviewView {
    std::string title;
    std::string caption;                     ///< below the picture; wrapped
    const BSplineSurface& surface;           ///< lives until the picture is written
    std::optional<Vector3> tip;              ///< marked by a pin [m]
    std::optional<ScanWindow> zoom;          ///< framed on the surface
    std::vector<Vector3> path;               ///< where the tip's apex went [m]
    std::optional<double> heightScale = {};  ///< factor of all heights; none: one that suits
};

class OffscreenPicture;

/// Puts the scan into a picture, as writeOverviewPicture() does. The view lives until the picture
/// is drawn.
void drawOverview(OffscreenPicture& picture, const OverviewView& view,
                  const PictureParts& parts = {});

/// Draws the scan in 3-D, colored by height, with the tip's position, its path and the zoom's
/// frame. Heights are drawn larger when they are small, and the picture says by how much. Parts of
/// the path high above the surface are left out. The same view gives the same bytes.
/// @throw Error when no display answers, or the file cannot be written
void writeOverviewPicture(const std::filesystem::path& path, const OverviewView& view,
                          PictureSize size = {});

}  // namespace asperity
