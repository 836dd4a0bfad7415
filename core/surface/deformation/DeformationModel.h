#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// Model of how the surface around the contact moves.
enum class DeformationModel : std::uint8_t {
    FourPoint,      ///< the four control points around the closest point, by the indentation: cheap
    ContactRadius,  ///< control points within the contact radius onto the tip: the paper's choice
    ClosedForm,     ///< every point by the contact model's displacement, also outside the contact
    HalfSpace,      ///< every point by boundary elements on the real topography around the closest
                    ///< point
};

template <>
inline constexpr auto kEnumTable<DeformationModel> = std::to_array<EnumRow<DeformationModel>>(
    {{DeformationModel::FourPoint, "four_point", "four points"},
     {DeformationModel::ContactRadius, "contact_radius", "contact radius"},
     {DeformationModel::ClosedForm, "closed_form", "closed form"},
     {DeformationModel::HalfSpace, "half_space", "half-space"}});

/// Returns whether the model shares the displacement between sample and tip; the others move the
/// sample alone.
[[nodiscard]] constexpr bool sharesDisplacement(DeformationModel model) noexcept {
    return model == DeformationModel::ClosedForm || model == DeformationModel::HalfSpace;
}

}  // namespace asperity
