#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity convert`: one height map of any readable file into another format.
void addConvertCommand(CLI::App& program);

}  // namespace asperity
