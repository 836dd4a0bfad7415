#include "app/exports/RasterPixels.h"

#include <QImage>

namespace asperity {

RasterImage rasterOf(const QImage& image) {
    const QImage pixels = image.convertToFormat(QImage::Format_RGBA8888);
    RasterImage raster{.width = pixels.width(), .height = pixels.height(), .pixels = {}};
    raster.pixels.reserve(raster.rowBytes() * static_cast<std::size_t>(raster.height));
    for (int row = 0; row < raster.height; ++row) {
        const std::uint8_t* line = pixels.constScanLine(row);
        raster.pixels.insert(raster.pixels.end(), line, line + raster.rowBytes());
    }
    return raster;
}

QImage imageOf(const RasterImage& raster) {
    return QImage(raster.pixels.data(), raster.width, raster.height,
                  static_cast<int>(raster.rowBytes()), QImage::Format_RGBA8888)
        .copy();
}

}  // namespace asperity
