#include "core/io/heightmap/png/PngWriter.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightCounts.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <png.h>
#include <utility>

// A 16-bit gray PNG whose text keys give the size and the heights of black and white, as Gwyddion
// reads and writes them. Source: docs/formats.md 9.

namespace asperity {

namespace {

constexpr int kBitDepth = 16;

/// tEXt is Latin-1; UTF-8 needs the newer iTXt.
bool isAscii(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// What the format allows as a keyword.
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

}  // namespace

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

}  // namespace asperity
