#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Adds `asperity curve`: approach and retract curves with snap-in and pull-off.
void addCurveCommand(CLI::App& program);

}  // namespace asperity
