#pragma once

#include <array>
#include <cstdint>

namespace asperity {

struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    // Written out for files that are compiled as C++17.
    friend constexpr bool operator==(const Color& a, const Color& b) {
        return a.red == b.red && a.green == b.green && a.blue == b.blue;
    }

    /// As VTK's properties take it: 0 ... 1 each.
    [[nodiscard]] std::array<double, 3> fractions() const {
        return {red / 255.0, green / 255.0, blue / 255.0};
    }
};

}  // namespace asperity
