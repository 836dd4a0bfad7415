#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// `asperity replay`: runs a recorded input again and compares every force.
void addReplayCommand(CLI::App& program);

}  // namespace asperity
