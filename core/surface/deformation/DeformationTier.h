#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// How the surface around the contact is moved.
enum class DeformationTier : std::uint8_t {
    FourPoint,      ///< the four control points around the closest point, by the indentation: cheap
    ContactRadius,  ///< control points within the contact radius onto the tip: the paper's choice
    ClosedForm,     ///< every point by the contact model's displacement, also outside the contact
    HalfSpace,      ///< every point by boundary elements on the real topography around the closest
                    ///< point
};

template <>
inline constexpr auto kEnumTable<DeformationTier> = std::to_array<EnumRow<DeformationTier>>(
    {{DeformationTier::FourPoint, "four_point", "four points"},
     {DeformationTier::ContactRadius, "contact_radius", "contact radius"},
     {DeformationTier::ClosedForm, "closed_form", "closed form"},
     {DeformationTier::HalfSpace, "half_space", "half-space"}});

/// Whether the tier shares the displacement between sample and tip; the others move the sample
/// alone.
[[nodiscard]] constexpr bool sharesDisplacement(DeformationTier tier) noexcept {
    return tier == DeformationTier::ClosedForm || tier == DeformationTier::HalfSpace;
}

}  // namespace asperity
