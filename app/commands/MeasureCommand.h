#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity measure`: roughness, profile, angle and step height of a height map.
void addMeasureCommand(CLI::App& program);

}  // namespace asperity
