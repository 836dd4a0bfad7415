#pragma once

namespace asperity {

struct Scene;
struct TickOutput;

/// Counts the ticks of a run whose contact law is out of its range, and how far their forces may be
/// off: Validity::LawOutOfRange alone holds for 2 % and for a wrong sign.
class LawRangeTally {
public:
    /// @param scene of the run
    void take(const Scene& scene, const TickOutput& output) noexcept;

    [[nodiscard]] long ticks() const noexcept { return ticks_; }
    /// Of them those whose force may have the wrong sign.
    [[nodiscard]] long ticksOfAnySign() const noexcept { return anySign_; }
    /// Largest error of a force [N].
    [[nodiscard]] double largestError() const noexcept { return largest_; }

private:
    long ticks_ = 0;
    long anySign_ = 0;
    double largest_ = 0.0;
};

}  // namespace asperity
