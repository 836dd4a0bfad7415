#pragma once

namespace asperity {

/// Friction of tip on sample, T = mu N + tau A, never negative. Source: docs/theory.md 8.
struct Friction {
    double coefficient = 0.0;    ///< mu
    double shearStrength = 0.0;  ///< tau [Pa]

    bool operator==(const Friction&) const = default;
};

}  // namespace asperity
