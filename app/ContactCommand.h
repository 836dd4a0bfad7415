#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// Adds `asperity contact`: force and contact for each case of a table.
void addContactCommand(CLI::App& program);

}  // namespace asperity
