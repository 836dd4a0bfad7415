#pragma once

#include <CLI/CLI.hpp>

namespace asperity {

/// `asperity project INPUT --points P.csv`: the closest point on the fitted surface for each row.
void addProjectCommand(CLI::App& program);

}  // namespace asperity
