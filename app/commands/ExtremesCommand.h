#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity extremes`: where each contact law, solver and the whole tick is exact, valid, flagged
/// or refused, over the whole range of tips, samples and levers.
void addExtremesCommand(CLI::App& program);

}  // namespace asperity
