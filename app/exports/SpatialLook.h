#pragma once

#include "app/exports/ExportView.h"
#include "ui/view/OffscreenZoom.h"

#include <algorithm>
#include <optional>

namespace asperity {

/// How a picture is drawn.
struct PictureSpec {
    PictureSize size;
    double dpi = 96.0;  ///< [dots an inch]: of the file, and by which letters and lines are sized
    bool transparent = false;
    PictureParts parts;
    std::optional<double> width = {};        ///< of the frame [m]
    std::optional<double> heightScale = {};  ///< factor of all heights

    /// Pixels per pixel of letters and lines.
    [[nodiscard]] double pixelRatio() const { return dpi / 96.0; }
    /// Letters shrink in a picture that has fewer pixels of letters than what is drawn needs.
    [[nodiscard]] PictureLook look(double leastWidth, double leastHeight) const {
        return {.pixelRatio =
                    std::min({pixelRatio(), size.width / leastWidth, size.height / leastHeight}),
                .transparent = transparent};
    }
};

/// How one of the views that are 3-D draws such a picture.
[[nodiscard]] OffscreenZoomLook spatialLook(ExportView view, const PictureSpec& spec);

}  // namespace asperity
