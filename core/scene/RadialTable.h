#pragma once

#include <array>
#include <functional>

namespace asperity {

/// A function of the distance from the contact's axis, sampled once and interpolated: densest
/// about the contact's rim, where the deformed surface bends most.
class RadialTable {
public:
    /// @param function [m -> m]
    /// @param rim      radius of the contact, or 0 [m]
    /// @param reach    distance up to which the table goes, > rim [m]
    RadialTable(const std::function<double(double)>& function, double rim, double reach);

    /// Beyond the reach its last value.
    [[nodiscard]] double at(double distance) const;

private:
    static constexpr int kInside = 32;    // intervals up to the rim
    static constexpr int kOutside = 256;  // and beyond it

    double rim_;
    double reach_;
    std::array<double, kInside + 1> inside_{};    ///< from the rim to the axis [m]
    std::array<double, kOutside + 1> outside_{};  ///< from the rim to the reach [m]
};

}  // namespace asperity
