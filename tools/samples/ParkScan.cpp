#include "tools/samples/ParkScan.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/io/ByteReader.h"

#include <memory>
#include <string_view>
#include <tiffio.h>

namespace asperity {

namespace {

constexpr std::uint32_t kSamplesTag = 50434;
constexpr std::uint32_t kHeaderTag = 50435;

// Offsets in the header [byte].
constexpr std::size_t kWidth = 100;
constexpr std::size_t kHeight = 104;
constexpr std::size_t kSizeX = 140;  // [um]
constexpr std::size_t kSizeY = 148;  // [um]
constexpr std::size_t kGain = 220;
constexpr std::size_t kScale = 228;
constexpr std::size_t kOffset = 236;
constexpr std::size_t kUnit = 244;
constexpr std::size_t kDataType = 348;
constexpr std::size_t kHeaderSize = 580;

constexpr std::string_view kMicrometer("u\0m\0\0", 6);  // UTF-16
constexpr std::int32_t kFloat = 2;

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

/// The bytes of a private tag, which the library keeps until the file is closed.
std::string_view bytesOf(TIFF* tiff, std::uint32_t tag, const std::string& file) {
    std::uint32_t count = 0;
    const void* bytes = nullptr;
    if (TIFFGetField(tiff, tag, &count, &bytes) != 1) {
        throw InputError(file, "tag " + std::to_string(tag), "missing: this is no Park TIFF");
    }
    return {static_cast<const char*>(bytes), count};
}

template <class Number>
Number at(std::string_view bytes, std::size_t place) {
    return littleEndian<Number>(bytes.substr(place, sizeof(Number)).data());
}

/// A map of the header's size, without heights.
HeightMap emptyMap(std::string_view header, const std::string& file) {
    if (header.size() < kHeaderSize || at<std::int32_t>(header, kDataType) != kFloat ||
        header.substr(kUnit, kMicrometer.size()) != kMicrometer) {
        throw InputError(file, "header", "expected heights in micrometers as 32-bit floats");
    }
    HeightMap map;
    map.columns = at<std::int32_t>(header, kWidth);
    map.rows = at<std::int32_t>(header, kHeight);
    if (map.columns < 1 || map.rows < 1) {
        throw InputError(file, "header", "expected a number of columns and rows");
    }
    map.pitchX = at<double>(header, kSizeX) * 1.0_um / map.columns;
    map.pitchY = at<double>(header, kSizeY) * 1.0_um / map.rows;
    return map;
}

}  // namespace

HeightMap readParkScan(const std::filesystem::path& path) {
    TIFFSetWarningHandler(nullptr);  // it warns of every private tag
    const std::string file = path.string();
    const std::unique_ptr<TIFF, CloseTiff> tiff(TIFFOpen(path.c_str(), "r"));
    if (!tiff) {
        throw InputError(file, "", "no TIFF that can be read");
    }
    const std::string_view header = bytesOf(tiff.get(), kHeaderTag, file);
    const std::string_view samples = bytesOf(tiff.get(), kSamplesTag, file);
    HeightMap map = emptyMap(header, file);
    const std::size_t count = map.index(map.rows, 0);
    if (samples.size() != count * sizeof(float)) {
        throw InputError(file, "samples", "as many as the header's pixels were expected");
    }
    const double scale = at<double>(header, kScale);
    const double perSample = at<double>(header, kGain) * (scale == 0.0 ? 1.0 : scale) * 1.0_um;
    const double zero = at<double>(header, kGain) * at<double>(header, kOffset) * 1.0_um;
    map.heights.reserve(count);
    for (int row = map.rows - 1; row >= 0; --row) {  // the lowest row comes first
        for (int column = 0; column < map.columns; ++column) {
            const auto sample = at<float>(samples, map.index(row, column) * sizeof(float));
            map.heights.push_back(sample * perSample + zero);
        }
    }
    return map;
}

HeightMap cropped(const HeightMap& map, int row, int column, int pixels) {
    HeightMap part{.columns = pixels, .rows = pixels, .pitchX = map.pitchX, .pitchY = map.pitchY};
    for (int r = row; r < row + pixels; ++r) {
        for (int c = column; c < column + pixels; ++c) {
            part.heights.push_back(map.at(r, c));
        }
    }
    return part;
}

HeightMap granularFilm(const HeightMap& film) {
    constexpr int kRow = 119;
    constexpr int kColumn = 122;
    constexpr int kPixels = 256;
    return cropped(film, kRow, kColumn, kPixels);
}

}  // namespace asperity
