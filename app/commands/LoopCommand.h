#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity loop`: the real-time loop in wall time beside a bare loop in the same run.
void addLoopCommand(CLI::App& program);

}  // namespace asperity
