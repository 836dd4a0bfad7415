#pragma once

#include "core/surface/Leveling.h"

#include <CLI/CLI.hpp>
#include <set>
#include <string>

namespace asperity {

/// An option that takes the name of a way of leveling.
template <class Target>
void addLevelingOption(CLI::App& command, Target& leveling, const std::string& whenAbsent) {
    std::set<std::string> keys;
    for (const Leveling one : kValues<Leveling>) {
        keys.insert(keyOf(one));
    }
    command
        .add_option_function<std::string>(
            "--level", [&leveling](const std::string& key) { leveling = *fromKey<Leveling>(key); },
            "leveling: none, plane (least squares) or rows (median of each); " + whenAbsent)
        ->check(CLI::IsMember(keys));
}

}  // namespace asperity
