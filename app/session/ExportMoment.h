#pragma once

#include "app/exports/SpatialLook.h"
#include "app/session/RunControl.h"
#include "core/surface/deformation/SurfaceDeformation.h"
#include "ui/view/ShownView.h"
#include "ui/window/ExportChoices.h"
#include "vtkplugins/pictures/Charts.h"

#include <memory>
#include <string>
#include <vector>

namespace asperity {

class MainWindow;

/// What the window showed at one moment, so that a preview and the file are of the same one. It
/// holds the scene: the run may end meanwhile.
struct ExportMoment {
    std::shared_ptr<const LoadedScene> loaded;  ///< whose description may change meanwhile
    std::string name;                           ///< of the scan's file, or of the shape
    TickSample sample;                          ///< that it showed
    PatchGrid patch;                            ///< of the surface around the tip
    ShownView view;                             ///< of the large view
    std::vector<TickSample> ticks;              ///< the last seconds until then, in order
    Chart cycles;                               ///< the force-distance curves that are drawn
    std::string distance;  ///< over which they are drawn, as a table's column names it
};

/// The present one, or that of a recording that is looked at. The window shows a run, which has
/// ticks.
[[nodiscard]] ExportMoment presentMoment(MainWindow& window, RunControl& runs);

/// How the large view is drawn into a picture.
[[nodiscard]] OffscreenZoomLook viewLook(const ExportMoment& moment, const PictureSpec& spec);

/// Draws the large view. For the window's thread. @throw Error
[[nodiscard]] RasterImage viewImage(const ExportMoment& moment, const PictureSpec& spec);

/// The charts of one of the plots. @throw Error where there is nothing to draw yet
[[nodiscard]] std::vector<Chart> chartsOf(const ExportMoment& moment, ExportSubject subject);

}  // namespace asperity
