#pragma once

#include "core/haptics/VirtualRun.h"
#include "ui/view/ZoomPicture.h"
#include "vtkplugins/pictures/DrawnWindow.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <vtkNew.h>

#include <optional>
#include <string>

class vtkRenderWindow;

namespace asperity {

struct Scene;

/// Parameters with which the large view is drawn into a file.
struct OffscreenZoomLook {
    PictureSize size;
    PictureLook look;
    PictureParts parts;
    std::optional<ViewDirection> side = {};  ///< none: as a scene starts in the window
    bool section = false;                    ///< the half before the tip is cut away
    std::optional<double> width = {};        ///< of the frame; none: as a scene starts [m]
    double heightScale = 1.0;                ///< see ViewOptions
    /// As a view of the window has it: camera, frame and options are not those above then.
    std::optional<ShownView> shown = {};
    /// That colors the surface, one that is known of any surface; none: the height, or what colors
    /// the window's view.
    std::optional<SurfaceQuantity> color = {};
};

/// The large view in a window that nobody sees, in light colors, with its color bars below it. It
/// goes on from one sample to the next as the live view does: one frame, one scale of colors.
class OffscreenZoom {
public:
    /// @param scene outlives this object
    /// @throw Error when the size or the width of the frame cannot be drawn, or there is no display
    OffscreenZoom(const Scene& scene, const OffscreenZoomLook& look);
    ~OffscreenZoom();
    OffscreenZoom(const OffscreenZoom&) = delete;
    OffscreenZoom& operator=(const OffscreenZoom&) = delete;

    /// Looks at a sample that will be drawn.
    void foresee(const TickSample& sample);
    /// From now on size and colors have room for all samples so far, and stay so.
    void keepScales();
    /// @param caption written in a corner; empty: nothing
    /// @throw Error when drawing fails
    [[nodiscard]] RasterImage draw(const TickSample& sample, const std::string& caption);
    /// Returns the size of one pixel of the screen's coordinates, across the view [m].
    [[nodiscard]] double metersPerPixel() const;

private:
    void setUp(const Scene& scene);
    [[nodiscard]] ViewOptions options() const;
    void setColor();
    void setWidth(double width);
    void show(const TickSample& sample);
    void aim();
    [[nodiscard]] RasterImage barsImage() const;

    const Scene& scene_;
    OffscreenZoomLook look_;
    PictureSize bars_;  ///< the lower part of the picture; no height: there are none
    PictureSize view_;  ///< the upper part
    vtkNew<vtkRenderWindow> window_;
    std::optional<ZoomPicture> picture_;
    ViewCamera camera_;
    std::optional<RasterImage> drawnBars_;
    bool moved_ = true;  ///< the surface at rest is to be shown again
};

}  // namespace asperity
