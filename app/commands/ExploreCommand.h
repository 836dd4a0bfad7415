#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity explore`: the main job without a user, on a virtual clock.
void addExploreCommand(CLI::App& program);

}  // namespace asperity
