#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneDescription.h"

namespace asperity {

/// Reads `level`, a step or a list of steps, and `level_points_m`; what is absent stays as it is.
/// @throw InputError
void readLeveling(TomlSection& section, SampleDescription& sample);

/// Writes them: one step as a text, as earlier versions had it.
void insertLeveling(const SampleDescription& sample, toml::table& table);

}  // namespace asperity
