#include "tests/core/io/heightmap/ImageFiles.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <array>
#include <cstdio>
#include <png.h>
#include <stdexcept>
#include <tiffio.h>

namespace asperity::test {

namespace {

std::size_t pixels(const PlainImage& image) {
    return static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
}

std::map<std::string, std::string> attributes(const Imf::Header& header) {
    std::map<std::string, std::string> text;
    for (auto each = header.begin(); each != header.end(); ++each) {
        if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&each.attribute())) {
            std::array<char, 32> digits{};
            std::snprintf(digits.data(), digits.size(), "%.17g", number->value());
            text[each.name()] = digits.data();
        }
        if (const auto* words = dynamic_cast<const Imf::StringAttribute*>(&each.attribute())) {
            text[each.name()] = words->value();
        }
    }
    return text;
}

}  // namespace

PlainImage readExr(const std::filesystem::path& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    PlainImage image{window.max.x + 1, window.max.y + 1, {}, attributes(file.header())};
    const Imf::Channel* channel = file.header().channels().findChannel("Y");
    if (channel == nullptr || channel->type != Imf::FLOAT) {
        throw std::runtime_error("no float channel Y");
    }
    std::vector<float> heights(pixels(image));
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(heights.data()), sizeof(float),
                                 sizeof(float) * static_cast<std::size_t>(image.columns)));
    file.setFrameBuffer(frame);
    file.readPixels(0, image.rows - 1);
    image.values.assign(heights.begin(), heights.end());
    return image;
}

PlainImage readTiff(const std::filesystem::path& path) {
    TIFF* tiff = TIFFOpen(path.c_str(), "r");
    if (tiff == nullptr) {
        throw std::runtime_error("no TIFF");
    }
    PlainImage image;
    std::uint16_t format = 0;
    float resolution = 0.0F;
    const char* description = nullptr;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &image.columns);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &image.rows);
    TIFFGetField(tiff, TIFFTAG_SAMPLEFORMAT, &format);
    TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &resolution);
    TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description);
    image.text["format"] = std::to_string(format);
    image.text["x per cm"] = std::to_string(resolution);
    image.text["description"] = description != nullptr ? description : "";
    std::vector<float> line(static_cast<std::size_t>(image.columns));
    for (int row = 0; row < image.rows; ++row) {
        TIFFReadScanline(tiff, line.data(), static_cast<std::uint32_t>(row));
        image.values.insert(image.values.end(), line.begin(), line.end());
    }
    TIFFClose(tiff);
    return image;
}

PlainImage readPng(const std::filesystem::path& path) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
        throw std::runtime_error("no PNG");
    }
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    PlainImage image;
    image.columns = static_cast<int>(png_get_image_width(png, info));
    image.rows = static_cast<int>(png_get_image_height(png, info));
    image.text["bits"] = std::to_string(png_get_bit_depth(png, info));
    png_bytepp lines = png_get_rows(png, info);
    for (int row = 0; row < image.rows; ++row) {
        for (int column = 0; column < image.columns; ++column) {
            const png_byte* sample = lines[row] + 2 * static_cast<std::size_t>(column);
            image.values.push_back(sample[0] * 256.0 + sample[1]);
        }
    }
    png_textp text = nullptr;
    int count = 0;
    png_get_text(png, info, &text, &count);
    for (int i = 0; i < count; ++i) {
        image.text[text[i].key] = text[i].text;
    }
    png_destroy_read_struct(&png, &info, nullptr);
    (void)std::fclose(file);
    return image;
}

}  // namespace asperity::test
