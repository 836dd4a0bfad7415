#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace asperity {

/// A unit with its SI prefix, and the factor from an SI value to it.
struct SiScale {
    double factor = 1.0;  ///< shown value = factor * SI value
    std::string unit;     ///< "nm", "µN"; UTF-8
};

/// The prefix (atto to tera) that shows `magnitude` to three digits as 1.00 ... 999.
/// Zero and values that are not finite keep the bare unit.
[[nodiscard]] inline SiScale siScaleFor(double magnitude, std::string_view unit) {
    static constexpr int kMin = -6;
    static constexpr std::array<const char*, 11> kPrefixes = {"a", "f", "p", "n", "µ", "m",
                                                              "",  "k", "M", "G", "T"};
    int power = 0;
    if (std::isfinite(magnitude) && magnitude != 0.0) {
        // 999.5 and above read "1000" with three digits: they get the next prefix.
        const double digits = std::log10(std::abs(magnitude) * (1000.0 / 999.5));
        power = std::clamp(static_cast<int>(std::floor(digits / 3.0)), kMin,
                           kMin + static_cast<int>(kPrefixes.size()) - 1);
    }
    const char* prefix = kPrefixes.at(static_cast<std::size_t>(power - kMin));
    return {std::pow(10.0, -3 * power), prefix + std::string(unit)};
}

/// A value for people, to three digits with the fitting prefix: "12.3 nN", "10 nm", "-4.56 µm".
[[nodiscard]] inline std::string formatSi(double value, const char* unit) {
    const SiScale scale = siScaleFor(value, unit);
    std::array<char, 32> digits{};
    const double shown = value == 0.0 ? 0.0 : value * scale.factor;  // never "-0"
    std::snprintf(digits.data(), digits.size(), "%.3g", shown);
    return std::string(digits.data()) + " " + scale.unit;
}

}  // namespace asperity
