#pragma once

namespace asperity {

/// An isotropic linear elastic material.
struct Elastic {
    double youngsModulus = 0.0;  ///< [Pa], > 0
    double poissonRatio = 0.0;   ///< 0 .. 0.5

    bool operator==(const Elastic&) const = default;
};

/// Sample and tip as one pair: what every contact law needs.
struct ContactPair {
    double tipRadius = 0.0;       ///< effective radius R [m]
    double reducedModulus = 0.0;  ///< E* [Pa]
    double workOfAdhesion = 0.0;  ///< w of the pair [J/m^2], >= 0

    bool operator==(const ContactPair&) const = default;
};

/// E* of two bodies [Pa]; infinite where both are rigid, and 0, which no contact law takes, where
/// one of them is no elastic body. Source: Hertz (1882); docs/theory.md 1.
[[nodiscard]] double reducedModulus(const Elastic& sample, const Elastic& tip) noexcept;

/// The part of the common surface displacement that the sample takes, 0 .. 1 (the tip takes the
/// rest; 0 where reducedModulus() is 0 or infinite). Source: docs/theory.md 4.3, rendering rule
/// (ii).
[[nodiscard]] double sampleShare(const Elastic& sample, const Elastic& tip) noexcept;

}  // namespace asperity
