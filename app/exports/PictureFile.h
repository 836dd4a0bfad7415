#pragma once

#include "app/charts/ChartPage.h"
#include "app/exports/ExportView.h"
#include "ui/view/OffscreenZoom.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

class QImage;

namespace asperity {

/// Size and look of a picture.
struct PictureSpec {
    PictureSize size;
    double dpi = 96.0;  ///< [dots an inch]: of the file, and by which letters and lines are sized
    bool transparent = false;
    PictureParts parts;
    std::optional<double> width = {};           ///< of the frame [m]
    std::optional<double> heightScale = {};     ///< factor of all heights
    std::optional<SurfaceQuantity> color = {};  ///< of a 3-D view; none: the usual one

    /// Pixels per pixel of letters and lines.
    [[nodiscard]] double pixelRatio() const { return dpi / 96.0; }
    /// Letters shrink in a picture that has fewer pixels of letters than what is drawn needs.
    [[nodiscard]] PictureLook look(double leastWidth, double leastHeight) const {
        return {.pixelRatio =
                    std::min({pixelRatio(), size.width / leastWidth, size.height / leastHeight}),
                .transparent = transparent};
    }
};

/// Returns the quantities by which 3-D views can be colored: those known of any surface.
[[nodiscard]] std::span<const SurfaceQuantity> exportColors();

/// Returns the quantity that colors a contact, if none is chosen: over the colors of a height map
/// its dent is hardly seen.
[[nodiscard]] constexpr SurfaceQuantity contactColor() { return SurfaceQuantity::Displacement; }

/// Returns the look of such a picture in one of the 3-D views.
[[nodiscard]] OffscreenZoomLook spatialLook(ExportView view, const PictureSpec& spec);

/// Writes pixels as PNG or TIFF, whole or not at all; without alpha where all of it is opaque.
/// @param dpi resolution that the file says [dots an inch]: pHYs of PNG, XResolution of TIFF
/// @throw Error when the file cannot be written
void writePicture(const std::filesystem::path& path, const RasterImage& image, ExportFormat format,
                  double dpi);

/// Pixels of Qt as files are written from them. @param image not null
[[nodiscard]] RasterImage rasterOf(const QImage& image);
/// Pixels as Qt shows them; a copy.
[[nodiscard]] QImage imageOf(const RasterImage& raster);

/// Lays charts out on a page of the size and with the parts that are asked for.
/// @throw Error, also where the page is too small
[[nodiscard]] ChartPage plotPage(std::span<const Chart> charts, const PictureSpec& spec);

/// Returns a page as pixels. There is a QGuiApplication.
[[nodiscard]] RasterImage drawnPage(const ChartPage& page, const PictureSpec& spec);

/// Writes charts as a page in any of the formats of a plot but a table. There is a QGuiApplication.
/// @throw Error, also where the page is too small
void writePlotPage(const std::filesystem::path& path, std::span<const Chart> charts,
                   const PictureSpec& spec, ExportFormat format);

/// Column of a journal: the width at which it prints a figure.
struct JournalColumn {
    const char* name;
    double width;  ///< [mm]
};

/// All that are known.
[[nodiscard]] std::span<const JournalColumn> journalColumns();
/// @throw Error naming those that there are
[[nodiscard]] const JournalColumn& journalColumn(const std::string& name);
/// Returns the columns as a text for people: "single (85 mm), ...".
[[nodiscard]] std::string journalColumnList();

}  // namespace asperity
