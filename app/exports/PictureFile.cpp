#include "app/exports/PictureFile.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <png.h>
#include <tiffio.h>
#include <vector>

namespace asperity {

namespace {

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

}  // namespace

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

}  // namespace asperity
