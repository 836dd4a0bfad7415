#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity replay`: runs a recorded input again and compares every force.
void addReplayCommand(CLI::App& program);

}  // namespace asperity
