#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// `asperity tradeoff`: measured cost and error of every fidelity tier.
void addTradeOffCommand(CLI::App& program);

}  // namespace asperity
