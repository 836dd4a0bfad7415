#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// A choice: what it costs and how wrong it is, both the less the better.
struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

/// Of each choice, whether no other is cheaper and as good, or better and as cheap.
[[nodiscard]] std::vector<bool> paretoFront(std::span<const CostAndError> choices);

/// The cheapest whose error is at most `tolerance`; their count where there is none.
[[nodiscard]] std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance);

}  // namespace asperity
