#include "core/io/heightmap/tiff/TiffDecoder.h"

#include "core/Error.h"
#include "core/io/heightmap/tiff/TiffValue.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <memory>
#include <tiffio.h>

namespace asperity {

namespace {

/// Returns the file's header with this directory as the first one.
std::string headerFor(const TiffDirectory& directory) {
    constexpr std::size_t kVersionPlace = 2;
    constexpr std::size_t kVersionBytes = 2;
    constexpr std::uint16_t kBigVersion = 43;
    std::string header = directory.bytes().start(kVersionPlace + kVersionBytes);
    const bool isBig = orderedNumber<std::uint16_t>(header.data() + kVersionPlace,
                                                    directory.order()) == kBigVersion;
    const std::size_t offsetBytes = isBig ? 8 : 4;
    header = directory.bytes().start(header.size() + (isBig ? 4 : 0));
    for (std::size_t i = 0; i < offsetBytes; ++i) {
        const std::size_t digit = directory.order() == ByteOrder::Little ? i : offsetBytes - 1 - i;
        header += static_cast<char>((directory.place() >> (8 * digit)) & 0xffU);
    }
    return header;
}

/// What the TIFF library reads from, and what went wrong on the way. Nothing of it is global.
struct TiffSource {
    const ByteSource& bytes;
    /// In place of the file's own. To go to a directory in the middle, the library would walk
    /// through all of those before it.
    std::string header;
    std::uint64_t place = 0;
    std::string message;         ///< the library's first one
    std::exception_ptr failure;  ///< of reading the bytes
};

TiffSource& sourceOf(thandle_t handle) { return *static_cast<TiffSource*>(handle); }

/// No exception may pass through the library, which is written in C.
tmsize_t readBytes(thandle_t handle, void* target, tmsize_t count) {
    TiffSource& source = sourceOf(handle);
    const std::uint64_t left = source.bytes.size() - std::min(source.place, source.bytes.size());
    const std::uint64_t taken = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(count));
    try {
        source.bytes.read(source.place, {static_cast<char*>(target), taken});
        if (source.place < source.header.size()) {
            source.header.copy(static_cast<char*>(target), taken, source.place);
        }
    } catch (...) {
        source.failure = std::current_exception();
        return -1;
    }
    source.place += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t writeNothing(thandle_t /*handle*/, void* /*bytes*/, tmsize_t /*count*/) { return -1; }

toff_t seek(thandle_t handle, toff_t offset, int from) {
    TiffSource& source = sourceOf(handle);
    const std::uint64_t start = from == SEEK_SET   ? 0
                                : from == SEEK_CUR ? source.place
                                                   : source.bytes.size();
    source.place = start + offset;
    return source.place;
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
    /// Where tags are repeated the library may take others than we do.
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
