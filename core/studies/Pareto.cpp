#include "core/studies/Pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

using Indices = std::vector<std::size_t>;

/// What cannot be told apart by its error stands in the order of its cost.
auto byError(std::span<const CostAndError> choices, double errorResolution) {
    return [=](std::size_t i) {
        return std::pair(std::max(choices[i].error, errorResolution), choices[i].cost);
    };
}

Indices allOf(std::span<const CostAndError> choices) {
    Indices all(choices.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

}  // namespace

std::vector<bool> paretoFront(std::span<const CostAndError> choices, const Resolution& resolution) {
    std::vector<bool> front(choices.size(), false);
    Indices order = allOf(choices);
    std::ranges::stable_sort(order, {}, byError(choices, resolution.error));
    double cheapest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        front[i] = choices[i].cost * (1.0 + resolution.cost) < cheapest;
        cheapest = front[i] ? choices[i].cost : cheapest;
    }
    return front;
}

std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance,
                           const Resolution& resolution) {
    Indices within = allOf(choices);
    std::erase_if(within, [&](std::size_t i) { return choices[i].error > tolerance; });
    double cheapest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : within) {
        cheapest = std::min(cheapest, choices[i].cost);
    }
    std::erase_if(within, [&](std::size_t i) {
        return choices[i].cost > cheapest * (1.0 + resolution.cost);
    });
    const auto best = std::ranges::min_element(within, {}, byError(choices, resolution.error));
    return best == within.end() ? choices.size() : *best;
}

}  // namespace asperity
