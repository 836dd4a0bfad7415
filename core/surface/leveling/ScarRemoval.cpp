#include "core/surface/leveling/ScarRemoval.h"

#include "core/surface/leveling/CountedPixels.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

/// Root mean square of the differences between pixels above each other [m].
template <class Heights>
double verticalRms(const BasicHeightMap<Heights>& map) {
    double square = 0.0;
    double pixels = 0.0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (!counts(map, row, column)) {
                continue;
            }
            pixels += 1.0;
            if (row + 1 < map.rows && counts(map, row + 1, column)) {
                const double step = map.at(row + 1, column) - map.at(row, column);
                square += step * step;
            }
        }
    }
    return pixels > 0.0 ? std::sqrt(square / pixels) : 0.0;
}

/// Finds scars of one sign, row by row.
template <class Heights>
class ScarSearch {
public:
    /// @param sign +1: scars above their surroundings, -1: below
    /// @param rms verticalRms(), above 0 [m]
    ScarSearch(const BasicHeightMap<Heights>& map, const ScarLimits& limits, double sign,
               double rms)
        : map_(map)
        , limits_(limits)
        , sign_(sign)
        , rms_(rms)
        , strengths_(static_cast<std::size_t>(limits.maxWidth) + 1,
                     std::vector<double>(static_cast<std::size_t>(map.columns), 0.0)) {}

    /// Adds the scars to the mask.
    void run(PixelMask& scars) {
        for (int row = 0; row + 2 < map_.rows; ++row) {
            for (int column = 0; column < map_.columns; ++column) {
                searchBelow(row, column);
            }
            std::vector<double>& below = strengthOf(row + 1);  // no later row adds to it
            addSegments(below, row + 1, scars);
            std::ranges::fill(below, 0.0);
        }
    }

private:
    [[nodiscard]] double height(int row, int column) const { return sign_ * map_.at(row, column); }
    std::vector<double>& strengthOf(int row) {
        return strengths_[static_cast<std::size_t>(row) % strengths_.size()];
    }

    /// The narrowest run of pixels below this one that stands out from it and from the pixel under
    /// the run.
    void searchBelow(int row, int column) {
        if (!counts(map_, row, column)) {
            return;
        }
        double top = std::numeric_limits<double>::infinity();
        for (int width = 1; width <= limits_.maxWidth; ++width) {
            const int under = row + width + 1;
            if (under >= map_.rows || !counts(map_, under - 1, column) ||
                !counts(map_, under, column)) {
                return;
            }
            top = std::min(top, height(under - 1, column));
            if (top - height(row, column) < limits_.soft * rms_) {
                return;  // a wider run stands out no more
            }
            const double bottom = std::max(height(row, column), height(under, column));
            if (top - bottom >= limits_.soft * rms_) {
                raise(row, width, column, bottom);
                return;
            }
        }
    }

    void raise(int row, int width, int column, double bottom) {
        for (int one = row + 1; one <= row + width; ++one) {
            double& strength = strengthOf(one)[static_cast<std::size_t>(column)];
            strength = std::max(strength, (height(one, column) - bottom) / rms_);
        }
    }

    /// Segments begin where a pixel stands out by the hard threshold and spread over neighbors that
    /// stand out by the soft one.
    void addSegments(std::vector<double>& strengths, int row, PixelMask& scars) const {
        for (std::size_t i = 1; i < strengths.size(); ++i) {
            spread(strengths[i - 1], strengths[i]);
        }
        for (std::size_t i = strengths.size() - 1; i > 0; --i) {
            spread(strengths[i], strengths[i - 1]);
        }
        std::size_t begin = 0;
        for (std::size_t i = 0; i <= strengths.size(); ++i) {
            if (i < strengths.size() && strengths[i] >= limits_.hard) {
                continue;
            }
            if (i - begin >= static_cast<std::size_t>(limits_.minLength)) {
                const auto start = static_cast<std::ptrdiff_t>(map_.index(row, 0));
                std::fill(scars.begin() + start + static_cast<std::ptrdiff_t>(begin),
                          scars.begin() + start + static_cast<std::ptrdiff_t>(i), true);
            }
            begin = i + 1;
        }
    }

    void spread(double from, double& to) const {
        if (from >= limits_.hard && to >= limits_.soft) {
            to = std::max(to, limits_.hard);
        }
    }

    const BasicHeightMap<Heights>& map_;
    ScarLimits limits_;
    double sign_;
    double rms_;  ///< [m]
    /// Of the rows that the search still reaches, by row number: how far each pixel stands out.
    std::vector<std::vector<double>> strengths_;
};

/// The nearest pixel from `row` on in this direction that holds data and is no scar; -1: none.
template <class Heights>
int nextGood(const BasicHeightMap<Heights>& map, const PixelMask& scars, int row, int column,
             int direction) {
    for (; row >= 0 && row < map.rows; row += direction) {
        if (counts(map, row, column) && !scars[map.index(row, column)]) {
            return row;
        }
    }
    return -1;
}

/// There is a good pixel above and below each scar: it was found by them, or they are scars
/// themselves that end before the edge.
template <class Heights>
double interpolated(const BasicHeightMap<Heights>& map, const PixelMask& scars, int row,
                    int column) {
    const int above = nextGood(map, scars, row, column, -1);
    const int below = nextGood(map, scars, row, column, 1);
    if (above < 0 || below < 0) {
        const int only = std::max(above, below);
        return only < 0 ? map.at(row, column) : map.at(only, column);
    }
    const double share = static_cast<double>(row - above) / (below - above);
    return (1.0 - share) * map.at(above, column) + share * map.at(below, column);
}

}  // namespace

template <class Heights>
PixelMask scarsOf(const BasicHeightMap<Heights>& map, const ScarLimits& limits) {
    requireUsable(map);
    const double rms = verticalRms(map);
    if (!(rms > 0.0)) {
        return {};
    }
    PixelMask scars(map.heights.size(), false);
    for (const double sign : {1.0, -1.0}) {
        ScarSearch<Heights>(map, limits, sign, rms).run(scars);
    }
    return std::ranges::find(scars, true) == scars.end() ? PixelMask() : scars;
}

template <class Heights>
std::size_t removeScars(BasicHeightMap<Heights>& map, const ScarLimits& limits) {
    const PixelMask scars = scarsOf(map, limits);
    if (scars.empty()) {
        return 0;
    }
    std::size_t removed = 0;
    PixelMask invalid = map.invalid.empty() ? PixelMask(scars.size(), false) : map.invalid;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const std::size_t pixel = map.index(row, column);
            if (scars[pixel]) {
                using Height = typename Heights::value_type;
                map.heights[pixel] = static_cast<Height>(interpolated(map, scars, row, column));
                invalid[pixel] = true;
                ++removed;
            }
        }
    }
    map.invalid = std::move(invalid);
    return removed;
}

template PixelMask scarsOf(const BasicHeightMap<std::vector<double>>&, const ScarLimits&);
template PixelMask scarsOf(const BasicHeightMap<PixelVector<float>>&, const ScarLimits&);
template std::size_t removeScars(BasicHeightMap<std::vector<double>>&, const ScarLimits&);
template std::size_t removeScars(BasicHeightMap<PixelVector<float>>&, const ScarLimits&);

}  // namespace asperity
