#pragma once

#include <filesystem>
#include <vector>

namespace asperity {

/// A measured area function of a tip: its area over the contact depth.
struct TipAreaFunction {
    std::vector<double> depth;  ///< of contact, from the apex; rising [m]
    std::vector<double> area;   ///< of contact at each depth; rising [m^2]
};

/// Reads an area function from a text of two columns without titles, contact depth in nm and area
/// in nm^2, or with a line of titles that name both with their units ("depth (nm), area (nm^2)").
/// Lines with '#' are comments. Source: docs/formats.md 21.
/// @throw InputError where a line holds no two numbers, depth or area fall, or there are fewer than
///        two points
[[nodiscard]] TipAreaFunction readTipAreaFunction(const std::filesystem::path& path);

}  // namespace asperity
