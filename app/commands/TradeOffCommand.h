#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity tradeoff`: measured cost and error of every model option.
void addTradeOffCommand(CLI::App& program);

}  // namespace asperity
