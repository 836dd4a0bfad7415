#include "tools/samples/ParkScan.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

HeightMap readParkScan(const std::filesystem::path& path) {
    const HeightMapFile file = readHeightMapFile(path);
    if (file.format != kParkFormat.name) {
        throw InputError(path.string(), "", "expected a Park Systems TIFF, found " + file.format);
    }
    return heightChannel(file, path, "").map;
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
