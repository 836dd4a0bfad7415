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

/// Below what choices cannot be told apart.
struct Resolution {
    double cost = 0.0;   ///< as a share
    double error = 0.0;  ///< errors below it count as that: nothing is known of them
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

/// Of each choice, whether it is cheaper than all on the front that are as near or nearer, the
/// nearest of all beginning the front: the cheapest of those that cannot be told from it.
[[nodiscard]] std::vector<bool> paretoFront(std::span<const CostAndError> choices,
                                            const Resolution& resolution);

/// Has results say whether they are on the front.
template <class Result>
void markFront(std::vector<Result>& results, const Resolution& resolution) {
    const std::vector<bool> front = paretoFront(costsAndErrors(results), resolution);
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].onFront = front[i];
    }
}

/// Of the choices whose error is at most `tolerance`: the nearest of those that cannot be told from
/// the cheapest. Their count where there is none.
[[nodiscard]] std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance,
                                         const Resolution& resolution);

}  // namespace asperity
