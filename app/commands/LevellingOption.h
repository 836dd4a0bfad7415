#pragma once

#include "core/surface/Levelling.h"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace asperity {

/// An option that takes the name of a way of levelling.
template <class Target>
void addLevellingOption(CLI::App& command, Target& levelling, const std::string& whenAbsent) {
    static const std::map<std::string, Levelling> kNames = {
        {"none", Levelling::None}, {"plane", Levelling::Plane}, {"rows", Levelling::Rows}};
    command
        .add_option_function<std::string>(
            "--level", [&levelling](const std::string& name) { levelling = kNames.at(name); },
            "levelling: none, plane (least squares) or rows (median of each); " + whenAbsent)
        ->check(CLI::IsMember({"none", "plane", "rows"}));
}

}  // namespace asperity
