#include "core/io/heightmap/tiff/TiffImage.h"

#include "core/Error.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/tiff/TiffDecoder.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace asperity {

namespace {

constexpr std::int64_t kUncompressed = 1;
constexpr std::int64_t kHighestBitFirst = 1;
/// No codec that is read packs better: a file that promises more is damaged.
constexpr std::uint64_t kTiffMaxRatio = 2000;
constexpr std::int64_t kTiffMaxSide = 65536;

constexpr ByteOrder kTiffNative =
    std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;

std::int64_t integerOr(const TiffDirectory& directory, TiffTag tag, std::int64_t missing) {
    return directory.integer(number(tag)).value_or(missing);
}

/// Strips or tiles where the file says how long they are; their spans are within it.
std::vector<ByteSpan> blocksOf(const TiffDirectory& directory, TiffTag offsets, TiffTag counts) {
    const std::vector<std::uint64_t> places = directory.wholeNumbers(number(offsets));
    const std::vector<std::uint64_t> sizes = directory.wholeNumbers(number(counts));
    if (places.size() != sizes.size()) {
        directory.fail("it has " + std::to_string(places.size()) + " strips or tiles, but " +
                       std::to_string(sizes.size()) + " lengths of them");
    }
    const std::uint64_t end = directory.bytes().size();
    std::vector<ByteSpan> blocks(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] > end || sizes[i] > end - places[i]) {
            directory.fail("strip or tile " + std::to_string(i + 1) +
                           " is beyond the end of the file, which has " + std::to_string(end) +
                           " bytes; it is truncated or damaged");
        }
        blocks[i] = {places[i], sizes[i]};
    }
    return blocks;
}

std::vector<ByteSpan> blocksOf(const TiffDirectory& directory, bool tiled) {
    return tiled ? blocksOf(directory, TiffTag::TileOffsets, TiffTag::TileByteCounts)
                 : blocksOf(directory, TiffTag::StripOffsets, TiffTag::StripByteCounts);
}

bool isTiled(const TiffDirectory& directory) { return directory.has(number(TiffTag::TileOffsets)); }

/// Those of a tile that may be larger than a small image.
constexpr std::uint64_t kMaxTilePixels = std::uint64_t{1} << 20U;

ImageSize blockSize(const TiffDirectory& directory, const TiffImage& image) {
    if (image.isTiled) {
        const ImageSize tile =
            checkedImageSize(directory.requireInteger(number(TiffTag::TileWidth)),
                             directory.requireInteger(number(TiffTag::TileLength)),
                             directory.bytes().name(), directory.name() + ", tile");
        if (tile.pixels() > std::max(4 * image.size.pixels(), kMaxTilePixels)) {
            directory.fail("its tiles of " + std::to_string(tile.columns) + " x " +
                           std::to_string(tile.rows) + " pixels are larger than the image");
        }
        return tile;
    }
    const std::int64_t rows = integerOr(directory, TiffTag::RowsPerStrip, kTiffMaxSide);
    if (rows < 1) {
        directory.fail("expected one or more rows a strip, found " + std::to_string(rows));
    }
    return {image.size.columns, static_cast<int>(std::min<std::int64_t>(rows, image.size.rows))};
}

/// Rows of a strip; the last one may have fewer.
int rowsOfStrip(const TiffImage& image, std::size_t strip) {
    const int first = static_cast<int>(strip) * image.block.rows;
    return std::min(image.block.rows, image.size.rows - first);
}

/// Checks that each strip or tile is long enough for what it holds.
void requireLengths(const TiffDirectory& directory, const TiffImage& image) {
    const auto down = (image.size.rows + image.block.rows - 1) / image.block.rows;
    const auto expected =
        static_cast<std::size_t>(image.blocksAcross()) * static_cast<std::size_t>(down);
    if (image.blocks.size() != expected) {
        directory.fail("expected " + std::to_string(expected) + " strips or tiles for " +
                       std::to_string(image.size.columns) + " x " +
                       std::to_string(image.size.rows) + " pixels, found " +
                       std::to_string(image.blocks.size()));
    }
    for (std::size_t i = 0; i < image.blocks.size(); ++i) {
        const std::uint64_t bytes =
            image.isPlain ? static_cast<std::uint64_t>(rowsOfStrip(image, i)) *
                                static_cast<std::uint64_t>(image.size.columns) * sizeOf(image.type)
                          : image.blockBytes() / kTiffMaxRatio;
        if (image.blocks[i].count < bytes) {
            directory.fail("strip or tile " + std::to_string(i + 1) + " has " +
                           std::to_string(image.blocks[i].count) + " bytes, expected " +
                           std::to_string(bytes) + " or more; the file is damaged");
        }
    }
}

ReadRow rowsOfStrips(const ByteSource& bytes, const TiffImage& image, bool bottomFirst) {
    return [&bytes, image, bottomFirst](int row, RowRoom& room, double* numbers) {
        const int stored = bottomFirst ? image.size.rows - 1 - row : row;
        SampleLayout line{
            .size = {image.size.columns, 1}, .type = image.type, .order = image.order};
        const auto strip = static_cast<std::size_t>(stored / image.block.rows);
        line.place = image.blocks[strip].place +
                     static_cast<std::uint64_t>(stored % image.block.rows) * line.rowBytes();
        rowsOf(bytes, line)(0, room, numbers);
    };
}

}  // namespace

TiffPixel tiffPixel(const TiffDirectory& directory) {
    return {.bits = integerOr(directory, TiffTag::BitsPerSample, 1),
            .samples = integerOr(directory, TiffTag::SamplesPerPixel, 1),
            .format = integerOr(directory, TiffTag::SampleFormat, 1),
            .photometric = integerOr(directory, TiffTag::Photometric, 1)};
}

std::optional<SampleType> sampleTypeOf(const TiffPixel& pixel) {
    constexpr std::int64_t kUnsigned = 1;
    constexpr std::int64_t kSigned = 2;
    constexpr std::int64_t kFloating = 3;
    const auto is = [&pixel](std::int64_t format, std::int64_t bits) {
        return pixel.format == format && pixel.bits == bits;
    };
    if (is(kUnsigned, 16)) {
        return SampleType::UInt16;
    }
    if (is(kUnsigned, 32)) {
        return SampleType::UInt32;
    }
    if (is(kSigned, 16)) {
        return SampleType::Int16;
    }
    if (is(kSigned, 32)) {
        return SampleType::Int32;
    }
    if (is(kFloating, 32)) {
        return SampleType::Float32;
    }
    if (is(kFloating, 64)) {
        return SampleType::Float64;
    }
    return std::nullopt;
}

TiffImage tiffImage(const TiffDirectory& directory, SampleType type) {
    TiffImage image{.type = type, .order = directory.order(), .isTiled = isTiled(directory)};
    image.size = checkedImageSize(directory.requireInteger(number(TiffTag::ImageWidth)),
                                  directory.requireInteger(number(TiffTag::ImageLength)),
                                  directory.bytes().name(), directory.name());
    image.block = blockSize(directory, image);
    image.blocks = blocksOf(directory, image.isTiled);
    const std::int64_t compression = integerOr(directory, TiffTag::Compression, kUncompressed);
    if (!isTiffCompressionRead(compression)) {
        directory.fail("it is compressed by method " + std::to_string(compression) +
                       ", which is not read; save it uncompressed, or with LZW or Deflate");
    }
    image.isPlain = compression == kUncompressed && !image.isTiled &&
                    integerOr(directory, TiffTag::FillOrder, kHighestBitFirst) == kHighestBitFirst;
    requireLengths(directory, image);
    return image;
}

void requireBlocks(const std::vector<TiffDirectory>& directories) {
    std::uint64_t total = 0;
    for (const TiffDirectory& directory : directories) {
        for (const ByteSpan& block : blocksOf(directory, isTiled(directory))) {
            total += block.count;
            if (total > directory.bytes().size()) {
                directory.fail("its strips or tiles overlap others; the file is damaged");
            }
        }
    }
}

void leaveOutCut(std::vector<TiffDirectory>& directories, WholeImages& images,
                 const std::function<std::string(const TiffDirectory&)>& nameOf) {
    std::vector<TiffDirectory> whole;
    for (TiffDirectory& directory : directories) {
        try {
            (void)blocksOf(directory, isTiled(directory));
            whole.push_back(std::move(directory));
        } catch (const InputError& error) {
            images.leaveOut(nameOf(directory), error);
        }
    }
    directories = std::move(whole);
}

ReadRow rowsOf(const TiffDirectory& directory, const TiffImage& image, bool bottomFirst) {
    if (image.isPlain) {
        return rowsOfStrips(directory.bytes(), image, bottomFirst);
    }
    // The places of its strips would take more memory than those of many images may.
    return rowsOfDecoded(
        [directory, type = image.type] {
            return decodeTiff(directory, tiffImage(directory, type));
        },
        {.size = image.size, .type = image.type, .order = kTiffNative, .bottomFirst = bottomFirst},
        directory.bytes().name());
}

}  // namespace asperity
