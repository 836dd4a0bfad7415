#include "core/fidelity/Pareto.h"

#include <algorithm>

namespace asperity {

std::vector<bool> paretoFront(std::span<const CostAndError> choices) {
    const auto beats = [](const CostAndError& a, const CostAndError& b) {
        return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
    };
    std::vector<bool> front;
    for (const CostAndError& choice : choices) {
        front.push_back(std::ranges::none_of(
            choices, [&](const CostAndError& other) { return beats(other, choice); }));
    }
    return front;
}

std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance) {
    std::size_t best = choices.size();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (choices[i].error <= tolerance &&
            (best == choices.size() || choices[i].cost < choices[best].cost)) {
            best = i;
        }
    }
    return best;
}

}  // namespace asperity
