#pragma once

namespace asperity {

/// Elasticity of a film on a rigid base under a tip.
struct FilmElasticity {
    double poissonRatio = 0.5;  ///< of the film, 0 .. 0.5
    /// The film's part of the compliance 1 / E* that both bodies would have as half-spaces, 0 .. 1;
    /// the tip, an elastic half-space, has the rest. 1: a rigid tip.
    double share = 1.0;

    bool operator==(const FilmElasticity&) const = default;
};

}  // namespace asperity
