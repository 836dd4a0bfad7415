#include "core/fidelity/Pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

/// Of an error: what is less near than that to another says the same in two digits.
constexpr double kNearer = 0.98;

using Indices = std::vector<std::size_t>;

/// The first of those that are nearest, as far as errors can be told.
std::size_t nearestOf(std::span<const std::size_t> group, std::span<const CostAndError> choices,
                      double errorResolution) {
    const auto key = [&](std::size_t i) {
        return std::pair(std::max(choices[i].error, errorResolution), i);
    };
    return *std::ranges::min_element(group, {}, key);
}

/// Of indices in the order of their cost: how many cost what the first does, as far as that can be
/// told.
std::size_t equallyCheap(std::span<const std::size_t> order, std::span<const CostAndError> choices,
                         double costResolution) {
    const double most = choices[order.front()].cost * (1.0 + costResolution);
    return static_cast<std::size_t>(
        std::ranges::count_if(order, [&](std::size_t i) { return choices[i].cost <= most; }));
}

Indices byCost(std::span<const CostAndError> choices) {
    Indices order(choices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return choices[i].cost; });
    return order;
}

}  // namespace

std::vector<bool> paretoFront(std::span<const CostAndError> choices, const Resolution& resolution) {
    std::vector<bool> front(choices.size(), false);
    double nearest = std::numeric_limits<double>::infinity();
    const Indices order = byCost(choices);
    for (std::span<const std::size_t> rest(order); !rest.empty();) {
        const std::size_t count = equallyCheap(rest, choices, resolution.cost);
        const std::size_t best = nearestOf(rest.first(count), choices, resolution.error);
        const double error = std::max(choices[best].error, resolution.error);
        front[best] = error < kNearer * nearest;
        nearest = front[best] ? error : nearest;
        rest = rest.subspan(count);
    }
    return front;
}

std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance,
                           const Resolution& resolution) {
    Indices within = byCost(choices);
    std::erase_if(within, [&](std::size_t i) { return choices[i].error > tolerance; });
    if (within.empty()) {
        return choices.size();
    }
    const std::size_t count = equallyCheap(within, choices, resolution.cost);
    return nearestOf(std::span(within).first(count), choices, resolution.error);
}

}  // namespace asperity
