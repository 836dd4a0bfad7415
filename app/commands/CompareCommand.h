#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Adds `asperity compare`: by how much the normal force of a run differs from that of another.
void addCompareCommand(CLI::App& program);

}  // namespace asperity
