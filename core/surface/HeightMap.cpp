#include "core/surface/HeightMap.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace asperity {

namespace {

template <class Heights>
HeightRows rowsAbove(const BasicHeightMap<Heights>& map, double datum) {
    requireUsable(map);
    const auto read = [&map, datum](int row, double* heights, const auto& holdsHeight) {
        for (int column = 0; column < map.columns; ++column) {
            const double height = map.at(row, column);
            heights[column] = holdsHeight(column, height)
                                  ? datum + height
                                  : std::numeric_limits<double>::quiet_NaN();
        }
    };
    HeightRows rows{.columns = map.columns,
                    .rows = map.rows,
                    .pitchX = map.pitchX,
                    .pitchY = map.pitchY,
                    .readRow = [&map, read](int row, double* heights) {
                        read(row, heights, [&map, row](int column, double height) {
                            return map.isValid(row, column) && isFiniteHeight(height);
                        });
                    }};
    if (!map.invalid.empty()) {
        rows.readFilledRow = [read](int row, double* heights) {
            read(row, heights, [](int, double height) { return isFiniteHeight(height); });
        };
    }
    return rows;
}

enum class Pixel : std::uint8_t { Unknown, Queued, Known };

/// Grows the known pixels into the unknown ones, one layer at a time.
template <class Map>
class Filler {
public:
    explicit Filler(Map& map) : map_(map), state_(map.heights.size(), Pixel::Unknown) {
        for (std::size_t i = 0; i < state_.size(); ++i) {
            if (isFiniteHeight(map.heights[i])) {
                state_[i] = Pixel::Known;
            }
        }
    }

    void run() {
        std::vector<Entry> layer = rim();
        while (!layer.empty()) {
            std::vector<double> heights;
            heights.reserve(layer.size());
            for (const Entry& entry : layer) {
                heights.push_back(meanOfKnown(entry));
            }
            for (std::size_t i = 0; i < layer.size(); ++i) {
                map_.heights[index(layer[i])] = static_cast<Height>(heights[i]);
                state_[index(layer[i])] = Pixel::Known;
            }
            layer = unknownAround(layer);
        }
    }

private:
    using Height = typename decltype(Map::heights)::value_type;

    struct Entry {
        int row = 0;
        int column = 0;
    };

    [[nodiscard]] std::size_t index(Entry entry) const {
        return map_.index(entry.row, entry.column);
    }

    /// Calls visit(entry, weight) for the pixels around `center`; diagonal ones are farther away.
    template <class Visit>
    void forEachNeighbor(Entry center, const Visit& visit) const {
        for (int row = center.row - 1; row <= center.row + 1; ++row) {
            for (int column = center.column - 1; column <= center.column + 1; ++column) {
                const bool isSelf = row == center.row && column == center.column;
                if (isSelf || row < 0 || column < 0 || row >= map_.rows || column >= map_.columns) {
                    continue;
                }
                const bool diagonal = row != center.row && column != center.column;
                visit(Entry{row, column}, diagonal ? 0.5 : 1.0);
            }
        }
    }

    [[nodiscard]] double meanOfKnown(Entry center) const {
        double sum = 0.0;
        double weights = 0.0;
        forEachNeighbor(center, [&](Entry entry, double weight) {
            if (state_[index(entry)] != Pixel::Known) {
                return;
            }
            sum += weight * static_cast<double>(map_.heights[index(entry)]);
            weights += weight;
        });
        return sum / weights;
    }

    /// Unknown pixels that touch a known one.
    std::vector<Entry> rim() {
        std::vector<Entry> known;
        for (int row = 0; row < map_.rows; ++row) {
            for (int column = 0; column < map_.columns; ++column) {
                const Entry entry{row, column};
                if (state_[index(entry)] != Pixel::Unknown) {
                    continue;
                }
                bool touches = false;
                forEachNeighbor(entry, [&](Entry other, double) {
                    touches = touches || state_[index(other)] == Pixel::Known;
                });
                if (touches) {
                    known.push_back(entry);
                }
            }
        }
        for (const Entry& entry : known) {
            state_[index(entry)] = Pixel::Queued;
        }
        return known;
    }

    std::vector<Entry> unknownAround(const std::vector<Entry>& layer) {
        std::vector<Entry> next;
        for (const Entry& entry : layer) {
            forEachNeighbor(entry, [&](Entry other, double) {
                if (state_[index(other)] != Pixel::Unknown) {
                    return;
                }
                state_[index(other)] = Pixel::Queued;
                next.push_back(other);
            });
        }
        return next;
    }

    Map& map_;
    std::vector<Pixel> state_;
};

template <class Map>
void markMissing(Map& map) {
    if (map.invalid.empty()) {
        map.invalid.resize(map.heights.size(), false);
    }
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        if (!isFiniteHeight(map.heights[i])) {
            map.invalid[i] = true;
        }
    }
}

template <class Map>
Map filled(Map map) {
    requireUsable(map);
    const auto isKnown = [](auto height) { return isFiniteHeight(height); };
    if (std::ranges::all_of(map.heights, isKnown)) {
        return map;
    }
    if (std::ranges::none_of(map.heights, isKnown)) {
        throw Error("the height map holds no valid pixel");
    }
    markMissing(map);
    Filler<Map>(map).run();
    return map;
}

}  // namespace

template <class Heights>
void requireUsable(const BasicHeightMap<Heights>& map) {
    if (map.columns < 1 || map.rows < 1) {
        throw Error("a height map needs at least one pixel");
    }
    if (!(std::isfinite(map.pitchX) && std::isfinite(map.pitchY)) || map.pitchX <= 0.0 ||
        map.pitchY <= 0.0) {
        throw Error("the pixel size of a height map must be a positive length");
    }
    const std::size_t pixels = map.index(map.rows, 0);
    if (map.heights.size() != pixels || (!map.invalid.empty() && map.invalid.size() != pixels)) {
        throw Error("a height map of " + std::to_string(map.columns) + " x " +
                    std::to_string(map.rows) + " pixels holds " +
                    std::to_string(map.heights.size()) + " heights");
    }
}

template void requireUsable(const BasicHeightMap<std::vector<double>>&);
template void requireUsable(const BasicHeightMap<PixelVector<float>>&);

double middleHeight(const HeightMap& map) {
    double lowest = std::numeric_limits<double>::max();
    double highest = -lowest;
    for (const double height : map.heights) {
        if (isFiniteHeight(height)) {
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    }
    if (lowest > highest) {
        return 0.0;
    }
    const double middle = 0.5 * lowest + 0.5 * highest;
    if (highest - middle > std::numeric_limits<float>::max()) {
        throw Error("the heights of the map lie too far apart for single precision");
    }
    return middle;
}

HeightRows rowsOf(const HeightMap& map) { return rowsAbove(map, 0.0); }
HeightRows rowsOf(const ScanMap& map) { return rowsAbove(map, map.datum); }

HeightMap withInvalidPixelsFilled(HeightMap map) { return filled(std::move(map)); }
ScanMap withInvalidPixelsFilled(ScanMap map) { return filled(std::move(map)); }

}  // namespace asperity
