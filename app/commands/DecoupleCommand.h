#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity decouple`: lever signals to three-dimensional forces with their covariance.
void addDecoupleCommand(CLI::App& program);

}  // namespace asperity
