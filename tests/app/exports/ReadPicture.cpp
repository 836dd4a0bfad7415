#include "tests/app/exports/ReadPicture.h"

#include <QImage>

#include <memory>
#include <stdexcept>
#include <tiffio.h>

namespace asperity::test {

namespace {

constexpr double kInch = 0.0254;  // m

ReadPicture readPng(const std::filesystem::path& path) {
    const QImage image(QString::fromStdString(path.string()), "png");
    if (image.format() != QImage::Format_RGB32 && image.format() != QImage::Format_ARGB32) {
        throw std::runtime_error(path.string() + " is no PNG in RGB of 8 bits");
    }
    ReadPicture picture{.width = image.width(),
                        .height = image.height(),
                        .channels = image.hasAlphaChannel() ? 4 : 3,
                        .dpi = image.dotsPerMeterX() * kInch,
                        .pixels = {}};
    const QImage bytes = image.convertToFormat(QImage::Format_RGBA8888);
    picture.pixels.assign(bytes.constBits(), bytes.constBits() + bytes.sizeInBytes());
    return picture;
}

/// Returns whether a TIFF is in RGB of 8 bits, an alpha channel not multiplied, its resolution an
/// inch.
bool isPlainRgb(TIFF* tiff) {
    std::uint16_t bits = 0;
    std::uint16_t colors = 0;
    std::uint16_t channels = 0;
    std::uint16_t unit = 0;
    std::uint16_t extras = 0;
    const std::uint16_t* kinds = nullptr;
    TIFFGetField(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &colors);
    TIFFGetField(tiff, TIFFTAG_SAMPLESPERPIXEL, &channels);
    TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &extras, &kinds);
    const bool hasAlpha = extras == 1 && kinds[0] == EXTRASAMPLE_UNASSALPHA;
    return bits == 8 && colors == PHOTOMETRIC_RGB && unit == RESUNIT_INCH &&
           (channels == 3 || (channels == 4 && hasAlpha));
}

ReadPicture readTiff(const std::filesystem::path& path) {
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "r"), &TIFFClose);
    if (!tiff || !isPlainRgb(tiff.get())) {
        throw std::runtime_error(path.string() + " is no TIFF in RGB of 8 bits");
    }
    ReadPicture picture;
    std::uint16_t channels = 0;
    float dpi = 0.0F;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &picture.width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &picture.height);
    TIFFGetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
    TIFFGetField(tiff.get(), TIFFTAG_XRESOLUTION, &dpi);
    picture.channels = channels;
    picture.dpi = dpi;
    std::vector<std::uint8_t> line(static_cast<std::size_t>(TIFFScanlineSize(tiff.get())));
    for (int row = 0; row < picture.height; ++row) {
        if (TIFFReadScanline(tiff.get(), line.data(), static_cast<std::uint32_t>(row)) != 1) {
            throw std::runtime_error(path.string() + " ends early");
        }
        for (std::size_t at = 0; at < line.size(); at += channels) {
            picture.pixels.insert(picture.pixels.end(), {line[at], line[at + 1], line[at + 2]});
            picture.pixels.push_back(channels == 4 ? line[at + 3] : 255);
        }
    }
    return picture;
}

}  // namespace

ReadPicture readPicture(const std::filesystem::path& path) {
    return path.extension() == ".png" ? readPng(path) : readTiff(path);
}

}  // namespace asperity::test
