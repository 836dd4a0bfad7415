#include "core/surface/InvalidPixels.h"

#include "core/Error.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace asperity {

namespace {

enum class Pixel : std::uint8_t { Unknown, Queued, Known };

/// Grows the known pixels into the unknown ones, one layer at a time.
class Filler {
public:
    explicit Filler(HeightMap& map) : map_(map), state_(map.heights.size(), Pixel::Unknown) {
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
                map_.heights[index(layer[i])] = heights[i];
                state_[index(layer[i])] = Pixel::Known;
            }
            layer = unknownAround(layer);
        }
    }

private:
    struct Place {
        int row = 0;
        int column = 0;
    };

    [[nodiscard]] std::size_t index(Place place) const {
        return map_.index(place.row, place.column);
    }

    /// Calls visit(place, weight) for the pixels around `centre`; diagonal ones are farther away.
    template <class Visit>
    void forEachNeighbour(Place centre, const Visit& visit) const {
        for (int row = centre.row - 1; row <= centre.row + 1; ++row) {
            for (int column = centre.column - 1; column <= centre.column + 1; ++column) {
                const bool isSelf = row == centre.row && column == centre.column;
                if (isSelf || row < 0 || column < 0 || row >= map_.rows || column >= map_.columns) {
                    continue;
                }
                const bool diagonal = row != centre.row && column != centre.column;
                visit(Place{row, column}, diagonal ? 0.5 : 1.0);
            }
        }
    }

    [[nodiscard]] double meanOfKnown(Place centre) const {
        double sum = 0.0;
        double weights = 0.0;
        forEachNeighbour(centre, [&](Place place, double weight) {
            if (state_[index(place)] != Pixel::Known) {
                return;
            }
            sum += weight * map_.heights[index(place)];
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
                forEachNeighbour(place, [&](Place other, double) {
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
            forEachNeighbour(place, [&](Place other, double) {
                if (state_[index(other)] != Pixel::Unknown) {
                    return;
                }
                state_[index(other)] = Pixel::Queued;
                next.push_back(other);
            });
        }
        return next;
    }

    HeightMap& map_;
    std::vector<Pixel> state_;
};

void markMissing(HeightMap& map) {
    if (map.invalid.empty()) {
        map.invalid.resize(map.heights.size(), 0);
    }
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        if (!isFiniteHeight(map.heights[i])) {
            map.invalid[i] = 1;
        }
    }
}

}  // namespace

HeightMap withInvalidPixelsFilled(HeightMap map) {
    requireUsable(map);
    const auto known =
        std::ranges::count_if(map.heights, [](double height) { return isFiniteHeight(height); });
    if (known == 0) {
        throw Error("the height map holds no valid pixel");
    }
    if (static_cast<std::size_t>(known) < map.heights.size()) {
        markMissing(map);
        Filler(map).run();
    }
    return map;
}

}  // namespace asperity
