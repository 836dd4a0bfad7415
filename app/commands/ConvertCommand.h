#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity convert`: height maps of any readable files into another format.
void addConvertCommand(CLI::App& program);

}  // namespace asperity
