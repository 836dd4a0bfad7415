#pragma once

#include "core/probe/MaterialMaps.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/SceneDescription.h"

#include <memory>
#include <string>

namespace asperity {

/// Those of the maps that the material names.
/// @param where of the scene, for the message @throw Error where it names one that is not there
[[nodiscard]] MaterialMaps mapsOf(const SampleMaterial& material, const MaterialMaps& read,
                                  const std::string& where);

/// The material with the largest value of each map in place of its number: the stiffest and most
/// adhesive part of the sample, by which a model is chosen, and devices and paths are limited.
[[nodiscard]] SampleMaterial withLargest(SampleMaterial material, const MaterialMaps& maps);

/// The law of the softest part of a sample with the adhesion of the most adhesive one: no part lets
/// a tip go later.
[[nodiscard]] ContactModel softestContact(const ProbeSystem& system) noexcept;

/// What the tip meets at each place; null without maps.
/// @param friction where there is no map of it
[[nodiscard]] std::shared_ptr<const MaterialField> materialField(MaterialMaps maps,
                                                                 const SampleMaterial& material,
                                                                 const Friction& friction,
                                                                 const Elastic& tip);

}  // namespace asperity
