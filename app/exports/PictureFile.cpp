#include "app/exports/PictureFile.h"

#include "app/charts/ChartFile.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/TemporaryFile.h"

#include <QImage>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <png.h>
#include <tiffio.h>
#include <vector>

namespace asperity {

namespace {

// In pixels of letters.
constexpr double kMinWidth = 480.0;
constexpr double kMinHeight = 360.0;

std::optional<ViewDirection> sideOf(ExportView view) {
    switch (view) {
    case ExportView::Front:
        return ViewDirection::Front;
    case ExportView::Back:
        return ViewDirection::Back;
    case ExportView::Right:
        return ViewDirection::Right;
    case ExportView::Left:
        return ViewDirection::Left;
    case ExportView::Top:
        return ViewDirection::Top;
    case ExportView::Bottom:
        return ViewDirection::Bottom;
    default:
        return std::nullopt;
    }
}

bool isOpaque(const RasterImage& image) {
    for (std::size_t at = 3; at < image.pixels.size(); at += RasterImage::kChannels) {
        if (image.pixels[at] != 255) {
            return false;
        }
    }
    return true;
}

/// Pixels as the file holds them.
struct PackedPixels {
    int channels = 0;  ///< 3, or 4 with alpha
    std::vector<std::uint8_t> bytes;
};

PackedPixels packed(const RasterImage& image) {
    const bool opaque = isOpaque(image);
    PackedPixels packed{.channels = opaque ? 3 : 4, .bytes = {}};
    if (!opaque) {
        packed.bytes = image.pixels;
        return packed;
    }
    packed.bytes.reserve(image.pixels.size() / 4 * 3);
    for (std::size_t at = 0; at < image.pixels.size(); at += RasterImage::kChannels) {
        const auto from = image.pixels.begin() + static_cast<std::ptrdiff_t>(at);
        packed.bytes.insert(packed.bytes.end(), from, from + 3);
    }
    return packed;
}

constexpr const char* kStopped = "writing stopped half-way (disk full?)";

/// Rows of the right size fail only where they cannot be written.
[[noreturn]] void failPng(png_structp /*png*/, png_const_charp /*reason*/) {
    throw Error(kStopped);
}

struct PngWriter {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, failPng, nullptr);
    png_infop info = png_create_info_struct(png);

    PngWriter() = default;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
};

void writePng(const std::filesystem::path& path, const RasterImage& image, double dpi) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"),
                                                               &std::fclose);
    if (!file) {
        throw Error("cannot be written");
    }
    const PackedPixels pixels = packed(image);
    PngWriter writer;
    png_init_io(writer.png, file.get());
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8,
                 pixels.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    const auto perMeter = static_cast<png_uint_32>(std::lround(dpi / 0.0254));
    png_set_pHYs(writer.png, writer.info, perMeter, perMeter, PNG_RESOLUTION_METER);
    png_write_info(writer.png, writer.info);
    const auto rowBytes =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(pixels.channels);
    for (int row = 0; row < image.height; ++row) {
        png_write_row(writer.png, pixels.bytes.data() + static_cast<std::size_t>(row) * rowBytes);
    }
    png_write_end(writer.png, nullptr);
    if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0) {
        throw Error(kStopped);
    }
}

void setTags(TIFF* tiff, const RasterImage& image, int channels, double dpi) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, channels);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, dpi);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, dpi);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
    if (channels == 4) {
        const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
    }
}

void writeTiff(const std::filesystem::path& path, const RasterImage& image, double dpi) {
    TIFFSetErrorHandler(nullptr);  // what failed is said once, below
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "w"), &TIFFClose);
    if (!tiff) {
        throw Error("cannot be written");
    }
    PackedPixels pixels = packed(image);
    setTags(tiff.get(), image, pixels.channels, dpi);
    const auto rowBytes =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(pixels.channels);
    bool isWritten = true;
    for (int row = 0; row < image.height && isWritten; ++row) {
        isWritten = TIFFWriteScanline(
                        tiff.get(), pixels.bytes.data() + static_cast<std::size_t>(row) * rowBytes,
                        static_cast<std::uint32_t>(row), 0) == 1;
    }
    if (!isWritten || TIFFFlush(tiff.get()) != 1) {
        throw Error(kStopped);
    }
}

constexpr std::array kExportColors{SurfaceQuantity::Height, SurfaceQuantity::Slope,
                                   SurfaceQuantity::Gap, SurfaceQuantity::Pressure,
                                   SurfaceQuantity::Displacement};

constexpr std::array<JournalColumn, 8> kColumns{{{"single", 85.0},
                                                 {"double", 174.0},
                                                 {"nature", 89.0},
                                                 {"nature-double", 183.0},
                                                 {"elsevier", 90.0},
                                                 {"elsevier-double", 190.0},
                                                 {"aps", 86.0},
                                                 {"aps-double", 178.0}}};

}  // namespace

std::span<const SurfaceQuantity> exportColors() { return kExportColors; }

OffscreenZoomLook spatialLook(ExportView view, const PictureSpec& spec) {
    return {.size = spec.size,
            .look = spec.look(kMinWidth, kMinHeight),
            .parts = spec.parts,
            .side = sideOf(view),
            .section = view == ExportView::Section,
            .width = spec.width,
            .heightScale = spec.heightScale.value_or(1.0),
            .color = spec.color};
}

void writePicture(const std::filesystem::path& path, const RasterImage& image, ExportFormat format,
                  double dpi) {
    const TemporaryFile file(path);
    try {
        format == ExportFormat::Png ? writePng(file.path(), image, dpi)
                                    : writeTiff(file.path(), image, dpi);
    } catch (const Error& error) {
        throw Error(path.string() + ": " + error.what());
    }
    file.commit();
}

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

ChartPage plotPage(std::span<const Chart> charts, const PictureSpec& spec) {
    return layOut(charts, {.width = spec.size.width / spec.pixelRatio(),
                           .height = spec.size.height / spec.pixelRatio(),
                           .parts = spec.parts});
}

RasterImage drawnPage(const ChartPage& page, const PictureSpec& spec) {
    return rasterOf(drawn(page, spec.pixelRatio(), spec.transparent));
}

void writePlotPage(const std::filesystem::path& path, std::span<const Chart> charts,
                   const PictureSpec& spec, ExportFormat format) {
    const ChartPage page = plotPage(charts, spec);
    if (format == ExportFormat::Svg) {
        writeSvg(path, page, spec.transparent);
    } else if (format == ExportFormat::Pdf) {
        writePdf(path, page, spec.transparent);
    } else {
        writePicture(path, drawnPage(page, spec), format, spec.dpi);
    }
}

std::span<const JournalColumn> journalColumns() { return kColumns; }

const JournalColumn& journalColumn(const std::string& name) {
    const auto* const found = std::ranges::find(kColumns, name, &JournalColumn::name);
    if (found == kColumns.end()) {
        throw Error("'" + name + "' is no column of a journal: expected one of " +
                    journalColumnList());
    }
    return *found;
}

std::string journalColumnList() {
    std::string list;
    for (const JournalColumn& column : kColumns) {
        list.append(list.empty() ? "" : ", ")
            .append(column.name)
            .append(formatted(" (%.0f mm)", column.width));
    }
    return list;
}

}  // namespace asperity
