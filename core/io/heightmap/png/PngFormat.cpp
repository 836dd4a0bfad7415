#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/MemoryLimit.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "core/io/heightmap/ImageScale.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <exception>
#include <iterator>
#include <memory>
#include <png.h>
#include <string>
#include <utility>
#include <vector>

// A PNG of 16-bit gray, whose texts may give size and heights as Gwyddion writes them. Gamma and
// color profiles are for screens and change no height. Written is a 16-bit gray PNG whose text keys
// give the size and the heights of black and white. Source: docs/formats.md 9.

namespace asperity {

namespace {

/// Header and texts of a PNG.
struct PngHeader {
    ImageSize size;
    int bits = 0;   ///< of a sample
    int color = 0;  ///< 0 gray, 2 color, 3 palette, 4 gray with transparency, 6 color with it
    std::uint64_t packedBytes = 0;     ///< of all pixels in the file
    BoundedTexts texts{kHeaderQuota};  ///< UTF-8
};

constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n";
/// A scale is a short text.
constexpr std::uint64_t kPngMaxText = 65536;

class ChunkWalk {
public:
    explicit ChunkWalk(const ByteSource& bytes)
        : bytes_(bytes), reader_(bytes, {kSignature.size(), bytes.size() - kSignature.size()}) {}

    PngHeader read() {
        if (next() != "IHDR") {
            fail("expected the header chunk IHDR");
        }
        takeHeader();
        for (std::string type = next(); type != "IEND"; type = next()) {
            if (type == "IDAT") {
                header_.packedBytes += length_;
            } else if (type == "tEXt") {
                takeText();
            } else if (type == "iTXt") {
                takeInternationalText();
            }
        }
        return std::move(header_);
    }

private:
    static constexpr std::uint64_t kLengthBytes = 4;
    static constexpr std::uint64_t kTypeBytes = 4;
    static constexpr std::uint64_t kSumBytes = 4;
    static constexpr std::uint64_t kFrameBytes = kLengthBytes + kTypeBytes + kSumBytes;

    /// The type of the next chunk, whose content is `length_` bytes long.
    std::string next() {
        (void)reader_.take(rest_, "a chunk");
        if (reader_.remaining() < kFrameBytes) {
            fail("expected a chunk; the file is truncated");
        }
        const std::uint64_t left = reader_.remaining() - kFrameBytes;
        const std::uint64_t offset = reader_.offset();
        std::string start(kLengthBytes + kTypeBytes, '\0');
        reader_.copy(start, "a chunk");
        length_ = bigEndian<std::uint32_t>(start.data());
        if (length_ > left) {
            failAt(offset, "a chunk of " + std::to_string(length_) +
                               " bytes is longer than the file, which is truncated or damaged");
        }
        rest_ = length_ + kSumBytes;
        return start.substr(kLengthBytes);
    }

    void takeHeader() {
        constexpr std::uint64_t kHeaderBytes = 13;
        constexpr std::size_t kPngRows = 4;
        constexpr std::size_t kPngBits = 8;
        constexpr std::size_t kColor = 9;
        if (length_ != kHeaderBytes) {
            fail("expected a header of " + std::to_string(kHeaderBytes) + " bytes");
        }
        const std::string data = content();
        header_.size = checkedImageSize(bigEndian<std::uint32_t>(data.data()),
                                        bigEndian<std::uint32_t>(data.data() + kPngRows),
                                        bytes_.name(), "IHDR");
        header_.bits = static_cast<unsigned char>(data[kPngBits]);
        header_.color = static_cast<unsigned char>(data[kColor]);
    }

    /// Keyword, NUL, text in Latin-1; some write UTF-8.
    void takeText() {
        const std::string data = shortContent();
        const std::size_t end = data.find('\0');
        if (end != std::string::npos) {
            header_.texts.add(data.substr(0, end), toUtf8(data.substr(end + 1)));
        }
    }

    /// Keyword, NUL, whether it is compressed, method, language, NUL, translated keyword, NUL, text
    /// in UTF-8.
    void takeInternationalText() {
        const std::string data = shortContent();
        const std::size_t keyword = data.find('\0');
        const std::size_t language =
            keyword == std::string::npos ? std::string::npos : data.find('\0', keyword + 3);
        const std::size_t translated =
            language == std::string::npos ? std::string::npos : data.find('\0', language + 1);
        if (translated != std::string::npos && data[keyword + 1] == '\0') {
            header_.texts.add(data.substr(0, keyword), toUtf8(data.substr(translated + 1)));
        }
    }

    /// The chunk's content, once.
    std::string content() {
        std::string data(static_cast<std::size_t>(length_), '\0');
        reader_.copy(data, "a chunk");
        rest_ -= length_;
        return data;
    }
    /// The same; nothing of one that is too long for a scale.
    std::string shortContent() { return length_ <= kPngMaxText ? content() : std::string(); }

    [[noreturn]] void fail(const std::string& what) const { failAt(reader_.offset(), what); }
    [[noreturn]] void failAt(std::uint64_t offset, const std::string& what) const {
        throw InputError(bytes_.name(), "byte " + std::to_string(offset), what);
    }

    const ByteSource& bytes_;
    ByteReader reader_;
    std::uint64_t length_ = 0;  ///< of the chunk's content
    std::uint64_t rest_ = 0;    ///< bytes up to the next chunk
    PngHeader header_;
};

/// The source of the PNG library, and what went wrong on reading it.
struct PngSource {
    ByteReader reader;
    std::string message;         ///< the library's own
    std::exception_ptr failure;  ///< of reading the bytes

    /// Keeps an exception: none may pass through the library, which is written in C.
    bool read(png_bytep target, std::size_t count) {
        try {
            reader.copy({reinterpret_cast<char*>(target), count}, "a chunk");
            return true;
        } catch (...) {
            failure = std::current_exception();
            return false;
        }
    }
};

void readBytes(png_structp png, png_bytep target, std::size_t count) {
    if (!static_cast<PngSource*>(png_get_io_ptr(png))->read(target, count)) {
        png_error(png, "the file cannot be read");
    }
}

/// The library comes back to where its jump buffer was set.
[[noreturn]] void jumpOut(png_structp png, png_const_charp message) {
    static_cast<PngSource*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}

void ignoreReadWarning(png_structp /*png*/, png_const_charp /*message*/) {}

/// The library's two structures of a file being read.
class PngInput {
public:
    explicit PngInput(PngSource& source)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, jumpOut, ignoreReadWarning))
        , info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw Error("the PNG library cannot start");
        }
        png_set_read_fn(png_, &source, readBytes);
        png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        // All but the pixels is checked and left out.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    }
    ~PngInput() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngInput(const PngInput&) = delete;
    PngInput& operator=(const PngInput&) = delete;

    /// The only function into which the library jumps back: nothing in it has a destructor.
    /// @return whether all was read
    bool readImage(png_bytepp rows, png_size_t rowBytes) {
        if (setjmp(png_jmpbuf(png_)) !=
            0) {  // NOLINT(cert-err52-cpp): the library has no other way
            return false;
        }
        png_read_info(png_, info_);
        png_set_strip_alpha(png_);
        (void)png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        if (png_get_rowbytes(png_, info_) != rowBytes) {
            png_error(png_, "rows of another length than the header says");
        }
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

private:
    png_structp png_;
    png_infop info_;
};

/// The signature of every PNG.
bool isPng(const ByteSource& bytes) { return bytes.startsWith(kSignature); }

/// Walks through all chunks up to the end mark, without a look at the pixels. Source: W3C,
/// Portable Network Graphics Specification, sections 5 and 11.
/// @throw InputError when one is not within the file, or the header is not valid
PngHeader readPngChunks(const ByteSource& bytes) {
    if (!isPng(bytes)) {
        throw InputError(bytes.name(), "", "this is no PNG");
    }
    return ChunkWalk(bytes).read();
}

/// All samples of a gray image of 16 bits, row after row from the top, the highest byte first;
/// transparency is left out. Any threads.
/// @throw InputError when the PNG library cannot decode it, or a checksum is wrong
std::string decodePng(const ByteSource& bytes, const PngHeader& header) {
    constexpr std::size_t kSampleBytes = 2;
    const std::size_t rowBytes = static_cast<std::size_t>(header.size.columns) * kSampleBytes;
    std::string samples(static_cast<std::size_t>(header.size.rows) * rowBytes, '\0');
    std::vector<png_bytep> rows(static_cast<std::size_t>(header.size.rows));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        rows[row] = reinterpret_cast<png_bytep>(samples.data() + row * rowBytes);
    }
    PngSource source{.reader = ByteReader(bytes)};
    PngInput file(source);
    if (!file.readImage(rows.data(), rowBytes)) {
        if (source.failure) {
            std::rethrow_exception(source.failure);
        }
        throw InputError(bytes.name(), "byte " + std::to_string(source.reader.offset()),
                         "the PNG library cannot decode it: " + source.message);
    }
    return samples;
}

constexpr int kBitDepth = 16;

/// tEXt is Latin-1; UTF-8 needs the newer iTXt.
bool isAscii(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Returns whether the format allows a text as a keyword.
bool isKeyword(const std::string& text) {
    constexpr std::size_t kMaxBytes = 79;
    return text.size() <= kMaxBytes && isAscii(text) && text.find("  ") == std::string::npos &&
           text != "Comment" &&
           std::ranges::none_of(text, [](char c) { return c < ' ' || c == 0x7f; });
}

ImageKeys textKeys(const HeightRows& map, const HeightMapMeta& meta, const HeightCounts& counts,
                   std::size_t missing) {
    ImageKeys keys = {
        {"Gwy::Title", oneLine(meta.title)},       {"Gwy::XReal", exactText(map.sizeX())},
        {"Gwy::YReal", exactText(map.sizeY())},    {"Gwy::XOffset", exactText(meta.originX)},
        {"Gwy::YOffset", exactText(meta.originY)}, {"Gwy::XYUnit", "m"}};
    std::ranges::move(counts.keys(oneLine(meta.unit)), std::back_inserter(keys));
    if (missing > 0) {
        keys.emplace_back("Comment", std::to_string(missing) +
                                         " pixels without data have the count 0, which no other "
                                         "pixel has");
    }
    for (const auto& [key, value] : writtenMetadata(meta)) {
        if (isKeyword(key)) {
            keys.emplace_back(key, value);
        }
    }
    return keys;
}

/// Big-endian samples of a row.
void encode(const std::vector<double>& heights, const HeightCounts& counts,
            std::vector<png_byte>& bytes) {
    bytes.clear();
    for (const double height : heights) {
        const unsigned gray = counts.countOf(height);
        bytes.push_back(static_cast<png_byte>(gray >> 8U));
        bytes.push_back(static_cast<png_byte>(gray & 0xFFU));
    }
}

/// Thrown through libpng, which is built with unwind tables and holds nothing that would leak.
[[noreturn]] void throwError(png_structp /*png*/, png_const_charp message) {
    throw Error(std::string_view(message) == "Write Error"
                    ? kStoppedHalfWay
                    : std::string("the PNG library reports: ") + message);
}

void ignoreWriteWarning(png_structp /*png*/, png_const_charp /*message*/) {}

struct CloseFile {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

FileHandle openForWriting(const std::filesystem::path& target) {
    FileHandle file(std::fopen(target.c_str(), "wb"));
    if (!file) {
        throw Error("the file cannot be opened");
    }
    return file;
}

/// libpng's two structures of a file being written.
class PngOutput {
public:
    explicit PngOutput(const std::filesystem::path& target)
        : file_(openForWriting(target))
        , png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, throwError,
                                       ignoreWriteWarning))
        , info_(png_create_info_struct(png_)) {
        if (info_ == nullptr) {
            png_destroy_write_struct(&png_, nullptr);
            throw Error("the PNG library cannot start");
        }
        png_init_io(png_, file_.get());
    }
    ~PngOutput() { png_destroy_write_struct(&png_, &info_); }
    PngOutput(const PngOutput&) = delete;
    PngOutput& operator=(const PngOutput&) = delete;

    void writeHeader(const HeightRows& map, const ImageKeys& keys) {
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(map.columns),
                     static_cast<png_uint_32>(map.rows), kBitDepth, PNG_COLOR_TYPE_GRAY,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        for (const auto& [key, value] : keys) {
            std::string keyCopy = key;
            std::string valueCopy = value;
            png_text text{};
            text.compression =
                isAscii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
            text.key = keyCopy.data();
            text.text = valueCopy.data();
            png_set_text(png_, info_, &text, 1);
        }
        png_write_info(png_, info_);
    }

    void writeRow(const std::vector<png_byte>& bytes) { png_write_row(png_, bytes.data()); }

    void finish() {
        png_write_end(png_, info_);
        if (std::fflush(file_.get()) != 0) {
            throw Error(kStoppedHalfWay);
        }
    }

private:
    FileHandle file_;
    png_structp png_;
    png_infop info_;
};

/// See HeightMapFormat::write.
void writePng(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    ProgressPart ranging(progress, 0.0, 0.1);
    const HeightRange range = heightRange(map, &ranging);
    const HeightCounts counts(range);
    PngOutput file(target);
    file.writeHeader(map, textKeys(map, meta, counts, range.missing));
    std::vector<png_byte> bytes;
    ProgressPart writing(progress, 0.1, 1.0);
    forEachRow(map, &writing, [&](int, const std::vector<double>& heights) {
        encode(heights, counts, bytes);
        file.writeRow(bytes);
    });
    file.finish();
}

constexpr int kGray = 0;
constexpr int kPalette = 3;
constexpr int kTransparentGray = 4;
constexpr int kPngBits = 16;

void requireHeights(const ByteSource& bytes, const PngHeader& header) {
    const bool isGray = header.color == kGray || header.color == kTransparentGray;
    if (isGray && header.bits == kPngBits) {
        return;
    }
    const std::string what = header.color == kPalette ? "a picture in false colors (palette)"
                             : !isGray
                                 ? "a color picture"
                                 : "a picture of " + std::to_string(header.bits) + "-bit gray";
    throw InputError(bytes.name(), "IHDR",
                     "this is " + what +
                         ", no height map: its pixels are no heights. One of 16-bit gray is "
                         "expected");
}

/// No data are packed better than this.
void requirePlausible(const ByteSource& bytes, const PngHeader& header) {
    constexpr std::uint64_t kPngMaxRatio = 1100;
    if (header.size.pixels() * sizeof(std::uint16_t) / kPngMaxRatio > header.packedBytes) {
        throw InputError(bytes.name(), "IDAT",
                         "its " + std::to_string(header.packedBytes) + " bytes cannot hold " +
                             std::to_string(header.size.columns) + " x " +
                             std::to_string(header.size.rows) + " pixels; the file is damaged");
    }
    requireUsualPacking(header.size.pixels() * sizeof(std::uint16_t), bytes.size(), bytes.name(),
                        "IDAT");
}

StoredScan readPng(const ByteSource& bytes) {
    const PngHeader header = readPngChunks(bytes);
    requireHeights(bytes, header);
    requirePlausible(bytes, header);
    const ImageScale scale = gwyScale(header.texts.all(), SampleType::UInt16, bytes.name(), "text");
    StoredChannel stored = scaledChannel(
        scale, header.size,
        rowsOfDecoded([&bytes, header] { return decodePng(bytes, header); },
                      {.size = header.size, .type = SampleType::UInt16, .order = ByteOrder::Big},
                      bytes.name()),
        "gray", bytes.name());
    if (header.color == kTransparentGray) {
        stored.channel.notes.emplace_back("its transparency is not used");
    }
    StoredScan result;
    result.texts.add(header.texts);
    result.channels.push_back(std::move(stored));
    result.provenance = {{"format", "PNG, 16-bit gray", "IHDR"},
                         {"orientation", "first stored row on top", "order of rows in PNG"}};
    return result;
}

constexpr std::array<std::string_view, 1> kPngExtensions{".png"};

}  // namespace

const HeightMapFormat kPngFormat = {.name = "PNG",
                                    .extensions = kPngExtensions,
                                    .recognizes = isPng,
                                    .read = readPng,
                                    .write = writePng};

}  // namespace asperity
