#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// `asperity experiment`: a positioning study by the operator model.
void addExperimentCommand(CLI::App& program);

}  // namespace asperity
