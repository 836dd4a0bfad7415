#pragma once

#include <algorithm>
#include <cmath>

namespace asperity::test {

/// Published closed-form approximations of the Maugis-Dugdale law in Maugis' units, for
/// plausibility only. From the literature, not derived. Source: Carpick, Ogletree, Salmeron (1999);
/// Pietrement, Troyon (2000); docs/theory.md 2.8.
class ClosedFormFits {
public:
    /// @param lambda transition parameter of Maugis-Dugdale
    explicit ClosedFormFits(double lambda)
        : alpha_((1.0 - std::exp(-lambda / 0.924)) / 1.02)
        , unloadedRadius_(1.54 + (0.279 * bend(2.28 * std::pow(lambda, 1.3))))
        , pullOff_(-1.75 + (0.25 * bend(4.04 * std::pow(lambda, 1.4)))) {}

    /// 0: DMT, 1: JKR.
    [[nodiscard]] double alpha() const { return alpha_; }
    [[nodiscard]] double unloadedRadius() const { return unloadedRadius_; }
    [[nodiscard]] double pullOff() const { return pullOff_; }

    /// Whether the fits have a state at this force.
    [[nodiscard]] bool reach(double force) const { return force >= pullOff_; }
    /// Carpick, Ogletree and Salmeron.
    [[nodiscard]] double contactRadius(double force) const {
        return unloadedRadius_ * std::pow(share(force), 2.0 / 3.0);
    }
    /// Pietrement and Troyon.
    [[nodiscard]] double indentation(double force) const {
        const double s = (-2.160 * std::pow(alpha_, 0.019)) + (2.7531 * std::pow(alpha_, 0.064)) +
                         (0.073 * std::pow(alpha_, 1.919));
        const double beta =
            alpha_ * (0.429 + (alpha_ * (0.235 + (alpha_ * (-0.683 + (alpha_ * 0.516))))));
        const double x = share(force);
        return unloadedRadius_ * unloadedRadius_ *
               (std::pow(x, 4.0 / 3.0) - (s * std::pow(x, 2.0 / 3.0 * beta)));
    }

private:
    static double bend(double x) { return (x - 1.0) / (x + 1.0); }

    [[nodiscard]] double share(double force) const {
        return (alpha_ + std::sqrt(std::max(0.0, 1.0 - (force / pullOff_)))) / (1.0 + alpha_);
    }

    double alpha_;
    double unloadedRadius_;
    double pullOff_;
};

}  // namespace asperity::test
