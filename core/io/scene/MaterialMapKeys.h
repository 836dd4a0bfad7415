#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/MaterialSources.h"

#include <filesystem>
#include <functional>

namespace asperity {

/// A material file as a mask's two are given.
using MaterialReader = std::function<MaskedMaterial(const std::filesystem::path&)>;

/// The keys of a section of a material on its maps; none where it has none of them.
/// @throw InputError
[[nodiscard]] MaterialSources readMaterialSources(TomlSection& section, const MaterialReader& read);
/// Those of the section [truth]: of what it says neither in a number nor in a map, the believed
/// ones. @param own that the section has
[[nodiscard]] MaterialSources trueSources(const TomlSection& section, MaterialSources own,
                                          const MaterialSources& believed);
void insertMaterialSources(const MaterialSources& sources, toml::table& table);

}  // namespace asperity
