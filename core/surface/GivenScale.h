#pragma once

#include <cmath>

namespace asperity {

/// Rounded once: 5 µm are 5e-6 m, not 4.9999999999999996e-6 m. @param unit [m]
[[nodiscard]] inline double inMeters(double number, double unit) {
    return unit < 1.0 ? number / std::round(1.0 / unit) : number * unit;
}

/// What a user says of a scan whose file does not say it.
struct GivenScale {
    double sizeX = 0.0;           ///< of the whole scan [m]; 0: as in the file
    double sizeY = 0.0;           ///< given together with sizeX [m]
    double heightPerValue = 0.0;  ///< height of a value of 1 [m]; 0: as in the file

    [[nodiscard]] bool hasSize() const { return sizeX > 0.0; }
    [[nodiscard]] bool hasHeight() const { return heightPerValue > 0.0; }

    bool operator==(const GivenScale&) const = default;
};

}  // namespace asperity
