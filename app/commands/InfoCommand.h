#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity info`: what a height-map file holds, for people or as JSON.
void addInfoCommand(CLI::App& program);

}  // namespace asperity
