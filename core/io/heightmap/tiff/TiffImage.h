#pragma once

#include "core/io/heightmap/tiff/TiffDirectory.h"

#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// Tags of pixels and strips in TIFF.
enum class TiffTag : std::uint16_t {
    NewSubfileType = 254,
    ImageWidth = 256,
    ImageLength = 257,
    BitsPerSample = 258,
    Compression = 259,
    Photometric = 262,
    FillOrder = 266,
    ImageDescription = 270,
    StripOffsets = 273,
    Orientation = 274,
    SamplesPerPixel = 277,
    RowsPerStrip = 278,
    StripByteCounts = 279,
    XResolution = 282,
    YResolution = 283,
    ResolutionUnit = 296,
    Software = 305,
    DateTime = 306,
    TileWidth = 322,
    TileLength = 323,
    TileOffsets = 324,
    TileByteCounts = 325,
    SampleFormat = 339
};
[[nodiscard]] constexpr std::uint16_t number(TiffTag tag) {
    return static_cast<std::uint16_t>(tag);
}

/// Samples and colors of a pixel.
struct TiffPixel {
    std::int64_t bits = 1;
    std::int64_t samples = 1;
    std::int64_t format = 1;       ///< 1 unsigned, 2 signed, 3 floating point
    std::int64_t photometric = 1;  ///< 0 white is zero, 1 black is zero, 3 palette, others color

    /// Returns whether it is one number.
    [[nodiscard]] bool isGray() const { return samples == 1 && photometric <= 1; }
    /// Returns whether small numbers are shown bright.
    [[nodiscard]] bool isInverted() const { return photometric == 0; }
};
[[nodiscard]] TiffPixel tiffPixel(const TiffDirectory& directory);
/// Empty when no sample of a height map is stored like this.
[[nodiscard]] std::optional<SampleType> sampleTypeOf(const TiffPixel& pixel);

/// Storage of the pixels of an image with one number a pixel.
struct TiffImage {
    ImageSize size;
    SampleType type = SampleType::Float32;
    ByteOrder order = ByteOrder::Little;
    bool isPlain = false;  ///< neither compressed nor in tiles
    bool isTiled = false;
    ImageSize block;               ///< pixels of a strip, or tile
    std::vector<ByteSpan> blocks;  ///< strips from the top, or tiles row after row

    [[nodiscard]] std::uint64_t blockBytes() const { return block.pixels() * sizeOf(type); }
    /// Returns the number of bytes decoded for it.
    [[nodiscard]] std::uint64_t decodedBytes() const {
        return isPlain ? 0 : size.pixels() * sizeOf(type);
    }
    [[nodiscard]] int blocksAcross() const {
        return (size.columns + block.columns - 1) / block.columns;
    }
};

/// @throw InputError when sizes do not fit together, the file does not hold all strips or tiles, or
///        they are packed in a way that is not read
[[nodiscard]] TiffImage tiffImage(const TiffDirectory& directory, SampleType type);

/// Checks the strips and tiles of all images, shown or not: that the file holds them, and that they
/// are together no larger than the file. @throw InputError
void requireBlocks(const std::vector<TiffDirectory>& directories);

/// Takes away the directories whose strips or tiles the file does not hold all, and those alone;
/// requireBlocks() finds other damage.
void leaveOutCut(std::vector<TiffDirectory>& directories, WholeImages& images,
                 const std::function<std::string(const TiffDirectory&)>& nameOf);

/// Reads the rows of an image: plain ones as they lie, others decoded by the TIFF library.
/// @param directory of this image; its source must outlive the result
/// @param bottomFirst the first stored row is the lowest of the image
[[nodiscard]] ReadRow rowsOf(const TiffDirectory& directory, const TiffImage& image,
                             bool bottomFirst);

/// Returns whether the compression is lossless and the TIFF library knows it.
[[nodiscard]] bool isTiffCompressionRead(std::int64_t compression);

/// All samples of an image, row after row from the first stored one, in the processor's byte order.
/// Any threads. @throw InputError when the TIFF library cannot decode it
[[nodiscard]] std::string decodeTiff(const TiffDirectory& directory, const TiffImage& image);

}  // namespace asperity
