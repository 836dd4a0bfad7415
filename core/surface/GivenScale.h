#pragma once

#include <cmath>
#include <string>

namespace asperity {

/// Rounded once: 5 µm are 5e-6 m, not 4.9999999999999996e-6 m. @param unit [m]
[[nodiscard]] inline double inMeters(double number, double unit) {
    return unit < 1.0 ? number / std::round(1.0 / unit) : number * unit;
}

/// Scale that a user gives for a scan whose file does not state it.
struct GivenScale {
    double sizeX = 0.0;           ///< of the whole scan [m]; 0: as in the file
    double sizeY = 0.0;           ///< given together with sizeX [m]
    double heightPerValue = 0.0;  ///< height of a value of 1 [m]; 0: as in the file

    [[nodiscard]] bool hasSize() const { return sizeX > 0.0; }
    [[nodiscard]] bool hasHeight() const { return heightPerValue > 0.0; }

    bool operator==(const GivenScale&) const = default;
};

/// Returns the values of both; those of `later` take precedence.
[[nodiscard]] inline GivenScale merged(const GivenScale& first, const GivenScale& later) {
    const GivenScale& size = later.hasSize() ? later : first;
    const GivenScale& height = later.hasHeight() ? later : first;
    return {size.sizeX, size.sizeY, height.heightPerValue};
}

/// Values that a file does not state of an image that could be a height map.
struct ScaleGap {
    std::string channel;
    int columns = 0;
    int rows = 0;
    bool size = false;    ///< the size of the scan is unknown
    bool height = false;  ///< the values are numbers without unit
    bool mask = false;    ///< by its values it is a mask, no height map

    bool operator==(const ScaleGap&) const = default;
};

}  // namespace asperity
