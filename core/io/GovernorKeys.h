#pragma once

#include "core/io/TomlFile.h"
#include "core/scene/GovernorLimits.h"

namespace asperity {

/// The keys of [haptics] that say what the force governor holds a force to. @throw InputError
[[nodiscard]] GovernorLimits readGovernorKeys(TomlSection& section,
                                              const GovernorLimits& otherwise);

/// The same keys, every value spelled out.
[[nodiscard]] toml::table governorTable(const GovernorLimits& governor);

}  // namespace asperity
