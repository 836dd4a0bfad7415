#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Adds `asperity contact`: force and contact for each case of a table.
void addContactCommand(CLI::App& program);

}  // namespace asperity
