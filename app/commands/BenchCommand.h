#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity bench`: all measurements of speed with their goals, beside other programs.
void addBenchCommand(CLI::App& program);

}  // namespace asperity
