#pragma once

#include "core/surface/Levelling.h"

#include <CLI/CLI.hpp>
#include <set>
#include <string>

namespace asperity {

/// An option that takes the name of a way of levelling.
template <class Target>
void addLevellingOption(CLI::App& command, Target& levelling, const std::string& whenAbsent) {
    std::set<std::string> keys;
    for (const Levelling one : kValues<Levelling>) {
        keys.insert(keyOf(one));
    }
    command
        .add_option_function<std::string>(
            "--level",
            [&levelling](const std::string& key) { levelling = *fromKey<Levelling>(key); },
            "levelling: none, plane (least squares) or rows (median of each); " + whenAbsent)
        ->check(CLI::IsMember(keys));
}

}  // namespace asperity
