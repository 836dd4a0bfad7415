#pragma once

#include <array>
#include <cstdint>

namespace asperity {

/// Random numbers that are the same on every platform for the same seed.
///
/// xoshiro256** by Blackman and Vigna, seeded by SplitMix64; the normal deviates by Box and Muller.
/// The state is the object: a copy continues with the same numbers. No allocation.
/// Source: D. Blackman, S. Vigna, "Scrambled linear pseudorandom number generators" (2021);
/// docs/synthetic_surfaces.md.
class Random {
public:
    explicit Random(std::uint64_t seed) noexcept;

    /// 64 random bits.
    [[nodiscard]] std::uint64_t bits() noexcept;
    /// Uniform in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double uniform() noexcept;
    /// Uniform in [low, high).
    [[nodiscard]] double uniform(double low, double high) noexcept;
    /// Normal deviate, mean 0 and standard deviation 1.
    [[nodiscard]] double normal() noexcept;

private:
    std::array<std::uint64_t, 4> state_{};
    double spare_ = 0.0;  ///< the second of the last pair of normal deviates
    bool hasSpare_ = false;
};

/// One step of SplitMix64: a well-mixed value from `state`, which it advances.
[[nodiscard]] std::uint64_t splitMix64(std::uint64_t& state) noexcept;

}  // namespace asperity
