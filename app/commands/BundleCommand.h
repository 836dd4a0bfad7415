#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Adds `asperity bundle`: a run with its scan and a picture in one file.
void addBundleCommand(CLI::App& program);

}  // namespace asperity
