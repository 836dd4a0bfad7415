#pragma once

namespace asperity {

/// The normal force with less noise: a straight line through about the last 20 ticks, which follows
/// a ramp without lag and starts anew at a jump. Its standard deviation is at most 0.42 of that of
/// one tick, for white noise. O(1), allocation-free.
/// Source: expanding-memory polynomial filter of degree 1, Morrison, Introduction to Sequential
/// Smoothing and Prediction (1969), with the memory held at 20 ticks.
class ForceTrend {
public:
    /// @param force of a tick [N]
    /// @param sigma its standard deviation, >= 0 [N]
    void take(double force, double sigma) noexcept;
    void clear() noexcept { *this = {}; }

    [[nodiscard]] double force() const noexcept { return force_; }  ///< of the latest tick [N]
    [[nodiscard]] double sigma() const noexcept { return sigma_; }  ///< of force() [N]
    /// Whether the sample pushes: by so much that noise alone does it once in days.
    [[nodiscard]] bool pushes() const noexcept { return force_ > kSure * sigma_; }
    [[nodiscard]] bool pulls() const noexcept { return force_ < -kSure * sigma_; }

private:
    static constexpr double kSure = 5.0;  ///< standard deviations

    double force_ = 0.0;
    double slope_ = 0.0;  ///< [N/tick]
    double sigma_ = 0.0;
    int ticks_ = 0;  ///< since the last start, at most kMemory
};

}  // namespace asperity
