#pragma once

#include "core/surface/leveling/LevelingStep.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The options --level and --level-points of a command that levels heights.
/// @param steps LevelingSteps or an optional of them; all must outlive the parse
template <class Steps>
void addLevelingOptions(CLI::App& command, Steps& steps, std::optional<LevelPoints>& points,
                        const std::string& whenAbsent) {
    command
        .add_option_function<std::string>(
            "--level", [&steps](const std::string& text) { steps = *levelingSteps(text); },
            "leveling steps in order, such as plane,scars,zero: " + levelingKeys() + "; " +
                whenAbsent)
        ->check(CLI::Validator(
            [](const std::string& text) {
                return levelingSteps(text) ? std::string()
                                           : "expected steps of " + levelingKeys() +
                                                 ", separated by commas, not '" + text + "'";
            },
            "STEP,..."));
    command
        .add_option_function<std::vector<double>>(
            "--level-points",
            [&points](const std::vector<double>& values) {
                LevelPoints three;
                for (std::size_t i = 0; i < three.size(); ++i) {
                    three[i] = {values[2 * i], values[2 * i + 1]};
                }
                if (const std::string refusal = refusalOf(three); !refusal.empty()) {
                    throw CLI::ValidationError("--level-points", refusal);
                }
                points = three;
            },
            "three points of three_point: x1,y1,x2,y2,x3,y3, from the lower left corner [m]")
        ->delimiter(',')
        ->expected(6);
}

}  // namespace asperity
