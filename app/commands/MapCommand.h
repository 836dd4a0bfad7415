#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Adds `asperity map`: a force curve or a raster line at each place of a scan.
void addMapCommand(CLI::App& program);

}  // namespace asperity
