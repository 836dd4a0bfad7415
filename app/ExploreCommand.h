#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// `asperity explore`: the main job without a person, on a virtual clock.
void addExploreCommand(CLI::App& program);

}  // namespace asperity
