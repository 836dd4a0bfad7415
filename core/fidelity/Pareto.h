#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// A choice: what it costs and how wrong it is, both the less the better.
struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

/// Of results that say so of themselves.
template <class Result>
[[nodiscard]] std::vector<CostAndError> costsAndErrors(const std::vector<Result>& results) {
    std::vector<CostAndError> choices;
    for (const Result& result : results) {
        choices.push_back(result.costAndError());
    }
    return choices;
}

/// Of each choice, whether no other is cheaper and as good, or better and as cheap.
[[nodiscard]] std::vector<bool> paretoFront(std::span<const CostAndError> choices);

/// Has results say whether they are on the front. Errors below `doubt`, that of what they are held
/// against, count as that.
template <class Result>
void markFront(std::vector<Result>& results, double doubt) {
    std::vector<CostAndError> choices = costsAndErrors(results);
    for (CostAndError& choice : choices) {
        choice.error = std::max(choice.error, doubt);
    }
    const std::vector<bool> front = paretoFront(choices);
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].onFront = front[i];
    }
}

/// The cheapest whose error is at most `tolerance`; their count where there is none.
[[nodiscard]] std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance);

}  // namespace asperity
