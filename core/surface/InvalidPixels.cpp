#include "core/surface/InvalidPixels.h"

#include "core/Error.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace asperity {

namespace {

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
        std::vector<Place> layer = rim();
        while (!layer.empty()) {
            std::vector<double> heights;
            heights.reserve(layer.size());
            for (const Place& place : layer) {
                heights.push_back(meanOfKnown(place));
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

    struct Place {
        int row = 0;
        int column = 0;
    };

    [[nodiscard]] std::size_t index(Place place) const {
        return map_.index(place.row, place.column);
    }

    /// Calls visit(place, weight) for the pixels around `center`; diagonal ones are farther away.
    template <class Visit>
    void forEachNeighbor(Place center, const Visit& visit) const {
        for (int row = center.row - 1; row <= center.row + 1; ++row) {
            for (int column = center.column - 1; column <= center.column + 1; ++column) {
                const bool isSelf = row == center.row && column == center.column;
                if (isSelf || row < 0 || column < 0 || row >= map_.rows || column >= map_.columns) {
                    continue;
                }
                const bool diagonal = row != center.row && column != center.column;
                visit(Place{row, column}, diagonal ? 0.5 : 1.0);
            }
        }
    }

    [[nodiscard]] double meanOfKnown(Place center) const {
        double sum = 0.0;
        double weights = 0.0;
        forEachNeighbor(center, [&](Place place, double weight) {
            if (state_[index(place)] != Pixel::Known) {
                return;
            }
            sum += weight * static_cast<double>(map_.heights[index(place)]);
            weights += weight;
        });
        return sum / weights;
    }

    /// Unknown pixels that touch a known one.
    std::vector<Place> rim() {
        std::vector<Place> known;
        for (int row = 0; row < map_.rows; ++row) {
            for (int column = 0; column < map_.columns; ++column) {
                const Place place{row, column};
                if (state_[index(place)] != Pixel::Unknown) {
                    continue;
                }
                bool touches = false;
                forEachNeighbor(place, [&](Place other, double) {
                    touches = touches || state_[index(other)] == Pixel::Known;
                });
                if (touches) {
                    known.push_back(place);
                }
            }
        }
        for (const Place& place : known) {
            state_[index(place)] = Pixel::Queued;
        }
        return known;
    }

    std::vector<Place> unknownAround(const std::vector<Place>& layer) {
        std::vector<Place> next;
        for (const Place& place : layer) {
            forEachNeighbor(place, [&](Place other, double) {
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

HeightMap withInvalidPixelsFilled(HeightMap map) { return filled(std::move(map)); }
ScanMap withInvalidPixelsFilled(ScanMap map) { return filled(std::move(map)); }

}  // namespace asperity
