#include "core/io/heightmap/tiff/TiffImage.h"

#include "core/Error.h"
#include "core/io/heightmap/WholeImages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <memory>
#include <tiffio.h>
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
    const std::vector<std::uint64_t> begins = directory.wholeNumbers(number(offsets));
    const std::vector<std::uint64_t> sizes = directory.wholeNumbers(number(counts));
    if (begins.size() != sizes.size()) {
        directory.fail("it has " + std::to_string(begins.size()) + " strips or tiles, but " +
                       std::to_string(sizes.size()) + " lengths of them");
    }
    const std::uint64_t end = directory.bytes().size();
    std::vector<ByteSpan> blocks(begins.size());
    for (std::size_t i = 0; i < begins.size(); ++i) {
        if (begins[i] > end || sizes[i] > end - begins[i]) {
            directory.fail("strip or tile " + std::to_string(i + 1) +
                           " is beyond the end of the file, which has " + std::to_string(end) +
                           " bytes; it is truncated or damaged");
        }
        blocks[i] = {begins[i], sizes[i]};
    }
    return blocks;
}

std::vector<ByteSpan> blocksOf(const TiffDirectory& directory, bool tiled) {
    return tiled ? blocksOf(directory, TiffTag::TileOffsets, TiffTag::TileByteCounts)
                 : blocksOf(directory, TiffTag::StripOffsets, TiffTag::StripByteCounts);
}

bool isTiled(const TiffDirectory& directory) { return directory.has(number(TiffTag::TileOffsets)); }

/// Pixels of a tile that may be larger than a small image.
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
        line.offset = image.blocks[strip].offset +
                      static_cast<std::uint64_t>(stored % image.block.rows) * line.rowBytes();
        rowsOf(bytes, line)(0, room, numbers);
    };
}

/// Returns the file's header with this directory as the first one.
std::string headerFor(const TiffDirectory& directory) {
    constexpr std::size_t kVersionOffset = 2;
    constexpr std::size_t kVersionBytes = 2;
    constexpr std::uint16_t kBigVersion = 43;
    std::string header = directory.bytes().start(kVersionOffset + kVersionBytes);
    const bool isBig = orderedNumber<std::uint16_t>(header.data() + kVersionOffset,
                                                    directory.order()) == kBigVersion;
    const std::size_t offsetBytes = isBig ? 8 : 4;
    header = directory.bytes().start(header.size() + (isBig ? 4 : 0));
    for (std::size_t i = 0; i < offsetBytes; ++i) {
        const std::size_t digit = directory.order() == ByteOrder::Little ? i : offsetBytes - 1 - i;
        header += static_cast<char>((directory.offset() >> (8 * digit)) & 0xffU);
    }
    return header;
}

/// The source of the TIFF library, and what went wrong on reading it. Nothing of it is global.
struct TiffSource {
    const ByteSource& bytes;
    /// In place of the file's own. To go to a directory in the middle, the library would walk
    /// through all of those before it.
    std::string header;
    std::uint64_t offset = 0;
    std::string message;         ///< the library's first one
    std::exception_ptr failure;  ///< of reading the bytes
};

TiffSource& sourceOf(thandle_t handle) { return *static_cast<TiffSource*>(handle); }

/// No exception may pass through the library, which is written in C.
tmsize_t readBytes(thandle_t handle, void* target, tmsize_t count) {
    TiffSource& source = sourceOf(handle);
    const std::uint64_t left = source.bytes.size() - std::min(source.offset, source.bytes.size());
    const std::uint64_t taken = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(count));
    try {
        source.bytes.read(source.offset, {static_cast<char*>(target), taken});
        if (source.offset < source.header.size()) {
            source.header.copy(static_cast<char*>(target), taken, source.offset);
        }
    } catch (...) {
        source.failure = std::current_exception();
        return -1;
    }
    source.offset += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t writeNothing(thandle_t /*handle*/, void* /*bytes*/, tmsize_t /*count*/) { return -1; }

toff_t seek(thandle_t handle, toff_t offset, int from) {
    TiffSource& source = sourceOf(handle);
    const std::uint64_t start = from == SEEK_SET   ? 0
                                : from == SEEK_CUR ? source.offset
                                                   : source.bytes.size();
    source.offset = start + offset;
    return source.offset;
}

int closeNothing(thandle_t /*handle*/) { return 0; }

toff_t sizeOfSource(thandle_t handle) { return sourceOf(handle).bytes.size(); }

int keepError(TIFF* /*tiff*/, void* source, const char* /*module*/, const char* format,
              va_list arguments) {
    constexpr std::size_t kMaxMessage = 300;
    std::array<char, kMaxMessage> text{};
    (void)std::vsnprintf(text.data(), text.size(), format, arguments);
    std::string& message = static_cast<TiffSource*>(source)->message;
    if (message.empty()) {
        message = text.data();
    }
    return 1;  // no other handler is asked
}

int ignoreWarning(TIFF* /*tiff*/, void* /*source*/, const char* /*module*/, const char* /*format*/,
                  va_list /*arguments*/) {
    return 1;
}

struct FreeOptions {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
struct CloseTiffInput {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffInput = std::unique_ptr<TIFF, CloseTiffInput>;

TiffInput open(TiffSource& source, std::uint64_t largestBlock) {
    constexpr std::uint64_t kMargin = std::uint64_t{1} << 20U;
    const std::unique_ptr<TIFFOpenOptions, FreeOptions> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepError, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignoreWarning, nullptr);
    TIFFOpenOptionsSetMaxSingleMemAlloc(
        options.get(), static_cast<tmsize_t>(source.bytes.size() + largestBlock + kMargin));
    // Not mapped into memory, strips as they are.
    return TiffInput(TIFFClientOpenExt(source.bytes.name().c_str(), "rmc", &source, readBytes,
                                       writeNothing, seek, closeNothing, sizeOfSource, nullptr,
                                       nullptr, options.get()));
}

class Decoder {
public:
    Decoder(const TiffDirectory& directory, const TiffImage& image)
        : directory_(directory)
        , image_(image)
        , source_{.bytes = directory.bytes(), .header = headerFor(directory)}
        , tiff_(open(source_, image.blockBytes())) {
        if (!tiff_) {
            fail();
        }
        requireSameImage();
    }

    std::string decode() {
        std::string samples;
        if (image_.isTiled) {
            appendTiles(samples);
        } else {
            appendStrips(samples);
        }
        return samples;
    }

private:
    /// Repeated tags: the library may take others than we do.
    void requireSameImage() {
        std::uint32_t columns = 0;
        std::uint32_t rows = 0;
        std::uint16_t bits = 0;
        std::uint16_t samples = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &columns);
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &rows);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &bits);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
        const auto block = image_.isTiled ? TIFFTileSize64(tiff_.get())
                                          : TIFFVStripSize64(tiff_.get(), rowsOfBlock());
        if (columns != static_cast<std::uint32_t>(image_.size.columns) ||
            rows != static_cast<std::uint32_t>(image_.size.rows) ||
            bits != 8 * sizeOf(image_.type) || samples != 1 || block != image_.blockBytes() ||
            (TIFFIsTiled(tiff_.get()) != 0) != image_.isTiled) {
            directory_.fail("its tags contradict each other; the file is damaged");
        }
    }

    [[nodiscard]] std::uint32_t rowsOfBlock() const {
        return static_cast<std::uint32_t>(image_.block.rows);
    }

    void appendStrips(std::string& samples) {
        const std::uint64_t rowBytes = image_.blockBytes() / rowsOfBlock();
        for (int row = 0; row < image_.size.rows; row += image_.block.rows) {
            const int rows = std::min(image_.block.rows, image_.size.rows - row);
            const std::uint64_t bytes = static_cast<std::uint64_t>(rows) * rowBytes;
            const std::size_t start = samples.size();
            samples.resize(start + bytes);
            const auto strip = static_cast<std::uint32_t>(row / image_.block.rows);
            requireAll(TIFFReadEncodedStrip(tiff_.get(), strip, samples.data() + start,
                                            static_cast<tmsize_t>(bytes)),
                       bytes);
        }
    }

    void appendTiles(std::string& samples) {
        std::string tile(image_.blockBytes(), '\0');
        std::uint32_t next = 0;
        const std::uint64_t rowBytes =
            static_cast<std::uint64_t>(image_.size.columns) * sizeOf(image_.type);
        for (int row = 0; row < image_.size.rows; row += image_.block.rows) {
            const int rows = std::min(image_.block.rows, image_.size.rows - row);
            const std::size_t start = samples.size();
            samples.resize(start + static_cast<std::uint64_t>(rows) * rowBytes);
            for (int across = 0; across < image_.blocksAcross(); ++across, ++next) {
                requireAll(TIFFReadEncodedTile(tiff_.get(), next, tile.data(),
                                               static_cast<tmsize_t>(tile.size())),
                           tile.size());
                copyTile(tile, across, rows, samples.data() + start);
            }
        }
    }

    /// @param target the first row that the tile is part of
    void copyTile(const std::string& tile, int across, int rows, char* target) const {
        const std::uint64_t sample = sizeOf(image_.type);
        const int first = across * image_.block.columns;
        const int columns = std::min(image_.block.columns, image_.size.columns - first);
        for (int row = 0; row < rows; ++row) {
            const auto line = static_cast<std::uint64_t>(row);
            std::copy_n(tile.data() +
                            line * static_cast<std::uint64_t>(image_.block.columns) * sample,
                        static_cast<std::uint64_t>(columns) * sample,
                        target + (line * static_cast<std::uint64_t>(image_.size.columns) +
                                  static_cast<std::uint64_t>(first)) *
                                     sample);
        }
    }

    void requireAll(tmsize_t decoded, std::uint64_t expected) {
        if (decoded < 0 || static_cast<std::uint64_t>(decoded) != expected) {
            fail();
        }
    }

    [[noreturn]] void fail() {
        if (source_.failure) {
            std::rethrow_exception(source_.failure);
        }
        directory_.fail("the TIFF library cannot decode it: " +
                        (source_.message.empty() ? "too few samples" : source_.message));
    }

    const TiffDirectory& directory_;
    const TiffImage& image_;
    TiffSource source_;
    TiffInput tiff_;
};

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
    // The offsets of its strips would need more memory than those of many images may.
    return rowsOfDecoded(
        [directory, type = image.type] {
            return decodeTiff(directory, tiffImage(directory, type));
        },
        {.size = image.size, .type = image.type, .order = kTiffNative, .bottomFirst = bottomFirst},
        directory.bytes().name());
}

bool isTiffCompressionRead(std::int64_t compression) {
    constexpr std::array<std::uint16_t, 7> kLossless = {
        COMPRESSION_NONE,     COMPRESSION_LZW,  COMPRESSION_ADOBE_DEFLATE, COMPRESSION_DEFLATE,
        COMPRESSION_PACKBITS, COMPRESSION_LZMA, COMPRESSION_ZSTD};
    return std::ranges::any_of(kLossless, [compression](std::uint16_t known) {
        return compression == known && TIFFIsCODECConfigured(known) != 0;
    });
}

std::string decodeTiff(const TiffDirectory& directory, const TiffImage& image) {
    return Decoder(directory, image).decode();
}

}  // namespace asperity
