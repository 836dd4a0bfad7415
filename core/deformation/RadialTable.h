#pragma once

#include <array>
#include <functional>

namespace asperity {

/// A function of the distance from the contact's axis, sampled once and interpolated, at any
/// distance: densest about the contact's rim, where the deformed surface bends most. Between the
/// samples it follows cubics, to about 1e-5 of its largest value beside a kink and far better
/// elsewhere.
class RadialTable {
public:
    /// @param function [m -> m], with a limit far away
    /// @param rim      radius of the contact, or 0 [m]
    /// @param scale    about the distance beyond the rim within which most happens, > 0 [m]
    RadialTable(const std::function<double(double)>& function, double rim, double scale);

    [[nodiscard]] double at(double distance) const;

private:
    static constexpr int kInside = 64;    // intervals up to the rim
    static constexpr int kOutside = 256;  // and beyond it

    double rim_;                                  ///< [m]
    double scale_;                                ///< [m]
    std::array<double, kInside + 1> inside_{};    ///< from the rim to the axis [m]
    std::array<double, kOutside + 1> outside_{};  ///< from the rim to far away [m]
};

}  // namespace asperity
