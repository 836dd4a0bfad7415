#include "core/haptics/cycle/ForceTrend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kMemory = 20;       ///< ticks
constexpr int kLongMemory = 100;  ///< ticks
constexpr double kJump = 6.0;     ///< standard deviations off the line
constexpr double kAgree = 3.0;    ///< standard deviations of the short line from the long one

/// Variance of the mean of some ticks about the continued least-squares line through those before,
/// in variances of a tick.
double varianceAfter(int ticksBefore, double ticks) noexcept {
    const double n = ticksBefore;
    const double ahead = 0.5 * (n + ticks);  // from the middle of the one to that of the other
    return 1.0 / ticks + 1.0 / n + 12.0 * ahead * ahead / (n * (n * n - 1.0));
}

}  // namespace

void ForceTrend::Line::take(double measured, double sigmaOfOne, int memory) noexcept {
    if (ticks == 0) {
        *this = {.force = measured,
                 .sigma = sigmaOfOne,
                 .variance = sigmaOfOne * sigmaOfOne,
                 .ticks = 1};
        return;
    }
    const double expected = force + slope;
    const double surprise = measured - expected;
    const double n = ticks;
    const double gain = 2.0 * (2.0 * n + 1.0) / ((n + 1.0) * (n + 2.0));
    force = expected + gain * surprise;
    slope += 6.0 / ((n + 1.0) * (n + 2.0)) * surprise;
    ticks = std::min(ticks + 1, memory);
    variance += (sigmaOfOne * sigmaOfOne - variance) / ticks;
    sigma = std::sqrt(gain * variance);
}

/// The slope of n ticks has the variance 12 / (n (n^2 - 1)) of one, the force about 4 / n.
bool ForceTrend::Line::agreesWith(const Line& other) const noexcept {
    const double slopeSigma = std::sqrt(3.0) / ticks * sigma;
    return std::abs(force - other.force) <= kAgree * sigma &&
           std::abs(slope - other.slope) <= kAgree * slopeSigma;
}

void ForceTrend::take(double force, double sigma) noexcept {
    const Tick tick{
        .force = force, .sigma = sigma, .before = long_, .straight = agreed_ >= kMemory};
    if (isFarOff(tick)) {
        clear();
        takeInLines(tick);
        return;
    }
    takeInLines(tick);
    if (const std::size_t after = ticksSinceJump(); after > 0) {
        const std::array<Tick, kRecent> recent = recent_;
        const std::size_t end = count_;
        clear();
        for (std::size_t i = end - after; i < end; ++i) {
            takeInLines({.force = recent[i].force, .sigma = recent[i].sigma, .before = long_});
        }
    }
}

double ForceTrend::along(double sign) const noexcept {
    double strongest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count_; ++i) {
        strongest = std::max(strongest, sign * recent_[i].force);
    }
    return std::min(sign * force(), strongest);
}

std::array<HalfForce, 2> ForceTrend::halves(double sign) const noexcept {
    const std::size_t other = 1 - latest_;
    std::array<HalfForce, 2> result;
    result[latest_] = halfAlong(sign, latest_);
    result[other] = count_ > 1 ? halfAlong(sign, other) : result[latest_];
    return result;
}

/// A half that did not take the latest tick is continued to it, by half of its own step: so far
/// ahead, a least-squares line has (2 n + 1) / (2 n - 2) times the variance of its end.
HalfForce ForceTrend::halfAlong(double sign, std::size_t index) const noexcept {
    const Half& half = halves_[index];
    const bool isLatest = index == latest_;
    const double ahead = isLatest ? 0.0 : 0.5;
    double strongest = -std::numeric_limits<double>::infinity();
    for (std::size_t back = isLatest ? 1 : 2; back <= count_; back += 2) {
        strongest = std::max(strongest, sign * recent_[count_ - back].force);
    }
    const auto at = [&](const Line& line) {
        return std::min(sign * line.force, strongest) + (ahead * sign * line.slope);
    };
    const double n = half.line.ticks;
    const double growth = isLatest || n < 2.0 ? 1.0 : (2.0 * n + 1.0) / (2.0 * n - 2.0);
    return {.smooth = at(half.smooth),
            .smoothSigma = half.smooth.sigma,
            .force = at(half.line),
            .sigma = std::sqrt(growth) * half.line.sigma};
}

void ForceTrend::takeInLines(const Tick& tick) noexcept {
    latest_ = 1 - latest_;
    halves_[latest_].line.take(tick.force, tick.sigma, kMemory / 2);
    halves_[latest_].smooth.take(tick.force, tick.sigma, kLongMemory / 2);
    if (count_ == kRecent) {
        std::shift_left(recent_.begin(), recent_.end(), 1);
        --count_;
    }
    recent_[count_++] = tick;
    line_.take(tick.force, tick.sigma, kMemory);
    long_.take(tick.force, tick.sigma, kLongMemory);
    agreed_ = line_.agreesWith(long_) ? agreed_ + 1 : 0;
}

bool ForceTrend::isFarOff(const Tick& tick) const noexcept {
    const double surprise = tick.force - (line_.force + line_.slope);
    return line_.ticks > 0 && std::abs(surprise) > kJump * std::hypot(tick.sigma, line_.sigma);
}

std::size_t ForceTrend::ticksSinceJump() const noexcept {
    std::size_t found = 0;
    double largest = kJump;
    for (std::size_t ticks = 2; ticks <= count_; ++ticks) {
        const double jump = jumpBefore(ticks);
        if (jump > largest) {
            largest = jump;
            found = ticks;
        }
    }
    return found;
}

double ForceTrend::jumpBefore(std::size_t ticks) const noexcept {
    const Tick& first = recent_[count_ - ticks];
    if (!first.straight || first.before.ticks <= kMemory) {
        return 0.0;
    }
    double off = 0.0;
    double sigma = 0.0;
    double expected = first.before.force;
    for (std::size_t i = count_ - ticks; i < count_; ++i) {
        expected += first.before.slope;
        off += recent_[i].force - expected;
        sigma = std::max(sigma, recent_[i].sigma);
    }
    const auto count = static_cast<double>(ticks);
    const double spread = sigma * std::sqrt(varianceAfter(first.before.ticks, count));
    return spread > 0.0 ? std::abs(off) / count / spread : 0.0;
}

}  // namespace asperity
