#pragma once

#include "core/scene/AsperityValidity.h"
#include "core/scene/Validity.h"

namespace asperity {

struct SampleMaterial;
struct Scene;

/// What the state of a tip on the scan does not hold for, by itself: nothing that takes signals or
/// an estimate. No allocation.
/// @param system that the state is of: what is believed, or what is true
/// @param material of that system
[[nodiscard]] ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                                        const SampleMaterial& material,
                                        const TipState& state) noexcept;
/// The same for one tick of many, see AsperityMemory.
[[nodiscard]] ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                                        const SampleMaterial& material, const TipState& state,
                                        AsperityMemory& memory) noexcept;

}  // namespace asperity
