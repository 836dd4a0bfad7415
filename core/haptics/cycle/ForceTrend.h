#pragma once

#include <array>
#include <cstddef>

namespace asperity {

/// The force by one half of the ticks, every second one: its noise is not that of the other half.
struct HalfForce {
    double smooth = 0.0;       ///< of about the last 100 ticks [N]
    double smoothSigma = 0.0;  ///< of `smooth` [N]
    double force = 0.0;        ///< of about the last 20 [N]
    double sigma = 0.0;        ///< of `force` [N]
};

/// The normal force with less noise: a straight line through about the last 20 ticks, which follows
/// a ramp without lag and starts again at a jump. Its standard deviation is at most 0.42 of that of
/// one tick, for white noise. O(1), allocation-free.
///
/// A jump shows in one tick far off the line, or, where the force went straight before, in the mean
/// of up to 8 ticks off the line through the last 100: across a jump that is small beside the noise
/// of a tick, the short line alone would bend and overshoot.
/// Source: expanding-memory polynomial filter of degree 1, Morrison, Introduction to Sequential
/// Smoothing and Prediction (1969), with the memory held at 20 and 100 ticks.
class ForceTrend {
public:
    /// @param force of a tick [N]
    /// @param sigma its standard deviation, >= 0 [N]
    void take(double force, double sigma) noexcept;
    void clear() noexcept { *this = {}; }

    [[nodiscard]] double force() const noexcept { return line_.force; }  ///< of the latest tick [N]
    [[nodiscard]] double sigma() const noexcept { return line_.sigma; }  ///< of force() [N]
    /// force() and its opposite, but not beyond each of the last 8 ticks: where the force bends
    /// within few ticks, as at a fast pull-off, the line goes on straight [N].
    [[nodiscard]] double push() const noexcept { return along(1.0); }
    [[nodiscard]] double pull() const noexcept { return along(-1.0); }
    /// Each half's view of the latest tick, not beyond each of its last 4: what is the strongest by
    /// one half is measured without bias by the other.
    /// @param sign 1: of the force, -1: of its opposite
    [[nodiscard]] std::array<HalfForce, 2> halves(double sign) const noexcept;
    /// Returns whether the sample pushes: the force exceeds five standard deviations, which white
    /// noise alone does once in days.
    [[nodiscard]] bool pushes() const noexcept { return force() > kSure * sigma(); }
    [[nodiscard]] bool pulls() const noexcept { return force() < -kSure * sigma(); }

private:
    static constexpr double kSure = 5.0;       ///< standard deviations
    static constexpr std::size_t kRecent = 8;  ///< ticks in which a jump shows

    /// A least-squares line through the last ticks.
    struct Line {
        double force = 0.0;  ///< at the latest tick [N]
        double slope = 0.0;  ///< [N/tick]
        double sigma = 0.0;  ///< of `force` [N]
        /// Mean of one tick [N^2]. The estimate of a tick with little noise claims little: the
        /// deviation of the latest one says nothing of those before.
        double variance = 0.0;
        int ticks = 0;  ///< since the start, at most the memory

        void take(double measured, double sigmaOfOne, int memory) noexcept;
        /// Returns whether the other line is the same force and slope within the noise of this one.
        [[nodiscard]] bool agreesWith(const Line& other) const noexcept;
    };
    struct Tick {
        double force = 0.0;     ///< [N]
        double sigma = 0.0;     ///< [N]
        Line before;            ///< the long line, without this tick
        bool straight = false;  ///< it went straight until then
    };

    /// Lines through every second tick.
    struct Half {
        Line line;
        Line smooth;
    };

    [[nodiscard]] double along(double sign) const noexcept;
    [[nodiscard]] HalfForce halfAlong(double sign, std::size_t index) const noexcept;
    void takeInLines(const Tick& tick) noexcept;
    [[nodiscard]] bool isFarOff(const Tick& tick) const noexcept;
    /// Number of the recent ticks that come after a jump; 0: there was none.
    [[nodiscard]] std::size_t ticksSinceJump() const noexcept;
    /// Distance of the last `ticks` ticks from the line before them, in standard deviations.
    [[nodiscard]] double jumpBefore(std::size_t ticks) const noexcept;

    Line line_;
    Line long_;
    std::array<Half, 2> halves_;
    std::size_t latest_ = 0;            ///< half that took the latest tick
    int agreed_ = 0;                    ///< ticks in a row after which both lines agreed
    std::array<Tick, kRecent> recent_;  ///< the oldest first
    std::size_t count_ = 0;             ///< of recent_, since the start
};

}  // namespace asperity
