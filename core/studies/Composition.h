#pragma once

#include "core/studies/TradeOffStudy.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity {

/// A whole way to run a scene: ticks of one kind at one rate, 1 kHz or more, and pictures of one
/// kind sixty times a second.
struct Composition {
    std::size_t tick = 0;   ///< index in TradeOff::ticks
    std::size_t rate = 0;   ///< in TradeOff::rates
    std::size_t frame = 0;  ///< in TradeOff::frames
    double load = 0.0;      ///< of one core
    /// The larger of two shares: of the force, what tick and rate miss together; of the
    /// indentation, what the picture does.
    double error = 0.0;

    [[nodiscard]] CostAndError costAndError() const { return {load, error}; }
};

/// Those that no other beats, the cheapest first.
[[nodiscard]] std::vector<Composition> bestCompositions(const TradeOff& study);

/// Of all whose error is at most `tolerance`: the nearest of those that cannot be told from the
/// cheapest.
[[nodiscard]] std::optional<Composition> cheapestComposition(const TradeOff& study,
                                                             double tolerance);

}  // namespace asperity
