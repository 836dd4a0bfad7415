#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/Uncertainty.h"

namespace asperity {

/// Reads [uncertainty], key by key of kEnumTable<UncertaintyInput>; what the section does not say
/// stays. A file of its own as those of the other sections whose keys follow a table.
/// @throw InputError for a key that is none
void readUncertainty(TomlSection section, Uncertainty& uncertainty);

/// The same as a table.
[[nodiscard]] toml::table uncertaintyTable(const Uncertainty& uncertainty);

}  // namespace asperity
