#include "core/io/heightmap/CroppedChannel.h"

#include "core/Error.h"

#include <algorithm>
#include <vector>

namespace asperity {

namespace {

std::string pixels(int columns, int rows) {
    return std::to_string(columns) + " x " + std::to_string(rows) + " pixels";
}

}  // namespace

std::string cropRefusal(const ScanChannel& channel, const PixelRectangle& part) {
    const HeightMap& whole = channel.map;
    return part.liesIn(whole.columns, whole.rows)
               ? std::string()
               : "a crop of " + pixels(part.columns, part.rows) + " from column " +
                     std::to_string(part.column) + ", row " + std::to_string(part.row) +
                     " is not within its " + pixels(whole.columns, whole.rows);
}

StoredChannel croppedChannel(const StoredChannel& stored, const PixelRectangle& part,
                             const std::string& file) {
    if (const std::string refusal = cropRefusal(stored.channel, part); !refusal.empty()) {
        throw InputError(file, "channel '" + stored.channel.name + "'", refusal);
    }
    StoredChannel cropped{.channel = stored.channel,
                          .factor = stored.factor,
                          .readRow = {},
                          .firstColumn = stored.firstColumn + part.column,
                          .firstRow = stored.firstRow + part.row};
    const HeightMap& all = stored.channel.map;
    cropped.channel.originX += part.column * all.pitchX;
    cropped.channel.originY += (all.rows - part.row - part.rows) * all.pitchY;
    cropped.channel.map.columns = part.columns;
    cropped.channel.map.rows = part.rows;
    cropped.readRow = [&stored, part](int row, RowRoom& room, double* numbers) {
        std::vector<double> whole(static_cast<std::size_t>(stored.channel.map.columns));
        stored.readRow(part.row + row, room, whole.data());
        std::copy_n(whole.begin() + part.column, part.columns, numbers);
    };
    return cropped;
}

}  // namespace asperity
