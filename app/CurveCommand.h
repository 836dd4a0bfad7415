#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// Adds `asperity curve`: approach and retract curves with snap-in and pull-off.
void addCurveCommand(CLI::App& program);

}  // namespace asperity
