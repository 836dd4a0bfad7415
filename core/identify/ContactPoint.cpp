#include "core/identify/ContactPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr std::size_t kMostSamples = 150;  ///< of a curve that is searched for its contact

/// Force over base at equal steps of the index, each the mean of its neighbors.
struct ThinnedBranch {
    std::vector<double> base;
    std::vector<double> force;

    [[nodiscard]] std::size_t size() const { return base.size(); }
    [[nodiscard]] std::size_t peak() const {
        return static_cast<std::size_t>(std::max_element(force.begin(), force.end()) -
                                        force.begin());
    }
};

ThinnedBranch thinned(const BranchSamples& approach, const std::vector<double>& force) {
    const std::size_t step = std::max<std::size_t>(1, approach.size() / kMostSamples);
    ThinnedBranch result;
    for (std::size_t first = 0; first + step <= approach.size(); first += step) {
        double base = 0.0;
        double sum = 0.0;
        for (std::size_t i = first; i < first + step; ++i) {
            base += approach.base[i];
            sum += force[i];
        }
        result.base.push_back(base / static_cast<double>(step));
        result.force.push_back(sum / static_cast<double>(step));
    }
    return result;
}

/// From the largest force back to where the smoothed force is down at six standard deviations.
std::optional<double> byDeviation(const BranchSamples& approach, const std::vector<double>& force,
                                  double noise) {
    constexpr double kDeparture = 6.0;
    constexpr double kRounding = 1e-9;
    constexpr std::size_t kWindows = 400;
    const auto peak =
        static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
    // Three samples at least: one that stands out is no contact.
    const std::size_t half = std::max<std::size_t>(1, approach.size() / (2 * kWindows));
    const double width = static_cast<double>((2 * half) + 1);
    // Without noise a force is zero only to the digits of its file.
    const double least = std::max(kDeparture * noise, kRounding * force[peak]);
    if (peak <= 2 * half || !(force[peak] > least)) {
        return std::nullopt;
    }
    std::size_t i = peak - half;
    double sum = 0.0;
    for (std::size_t j = i - half; j <= i + half; ++j) {
        sum += force[j];
    }
    if (!(sum / width > least)) {
        return std::nullopt;
    }
    while (i > half && sum / width > least) {
        --i;
        sum += force[i - half] - force[i + half + 1];
    }
    return i > half ? std::optional(approach.base[i]) : std::nullopt;
}

/// Returns the sample, between the second one and the peak, from which on a model has the least sum
/// of squares: of few, then of all around the best.
template <class Squares>
std::optional<double> bestBreak(const ThinnedBranch& branch, const Squares& squares) {
    constexpr std::size_t kStep = 6;
    constexpr std::size_t kFirst = 2;
    const std::size_t peak = branch.peak();
    if (peak < kFirst + 5) {
        return std::nullopt;
    }
    const std::size_t last = peak - 5;
    std::size_t best = kFirst;
    double least = std::numeric_limits<double>::infinity();
    const auto search = [&](std::size_t from, std::size_t to, std::size_t step) {
        for (std::size_t i = from; i <= to; i += step) {
            const double found = squares(branch.base[i]);
            if (found < least) {
                least = found;
                best = i;
            }
        }
    };
    search(kFirst, last, kStep);
    const std::size_t middle = best;
    search(std::max(kFirst, middle - std::min(middle, kStep)), std::min(last, middle + kStep), 1);
    // At an end of the data the contact is outside of it.
    return best > kFirst && best < last ? std::optional(branch.base[best]) : std::nullopt;
}

/// Least sum of squares about c0 + c1 x + c2 p(x) up to the peak, x from the contact on and
/// p(x) = x^exponent beyond it, else 0. @param tilted false: c1 = 0
double squaresAbout(const ThinnedBranch& branch, std::size_t peak, double contact, bool tilted,
                    double exponent) {
    const double scale = branch.base[peak] - contact;
    double n = 0.0;
    double f = 0.0;
    double x1 = 0.0;
    double p1 = 0.0;
    double xx = 0.0;
    double xp = 0.0;
    double pp = 0.0;
    double xf = 0.0;
    double pf = 0.0;
    double ff = 0.0;
    for (std::size_t i = 0; i <= peak; ++i) {
        const double x = (branch.base[i] - contact) / scale;
        const double beyond = std::max(0.0, x);
        const double p = exponent == 1.0   ? beyond
                         : exponent == 2.0 ? beyond * beyond
                                           : beyond * std::sqrt(beyond);
        n += 1.0;
        f += branch.force[i];
        x1 += x;
        p1 += p;
        xx += x * x;
        xp += x * p;
        pp += p * p;
        xf += x * branch.force[i];
        pf += p * branch.force[i];
        ff += branch.force[i] * branch.force[i];
    }
    // About the means: two unknowns are left.
    xx -= x1 * x1 / n;
    xp -= x1 * p1 / n;
    pp -= p1 * p1 / n;
    xf -= x1 * f / n;
    pf -= p1 * f / n;
    ff -= f * f / n;
    if (!tilted) {
        return ff - (pf * pf / pp);
    }
    const double determinant = (xx * pp) - (xp * xp);
    return ff - (((pp * xf * xf) - (2.0 * xp * xf * pf) + (xx * pf * pf)) / determinant);
}

std::optional<double> byGradient(const ThinnedBranch& branch) {
    constexpr double kShare = 0.05;
    constexpr std::size_t kReach = 3;  // samples to either side
    const std::size_t count = branch.size();
    if (count <= (2 * kReach) + 1) {
        return std::nullopt;
    }
    std::vector<double> slope(count, 0.0);
    for (std::size_t i = kReach; i + kReach < count; ++i) {
        const double run = branch.base[i + kReach] - branch.base[i - kReach];
        slope[i] = run > 0.0 ? (branch.force[i + kReach] - branch.force[i - kReach]) / run : 0.0;
    }
    const auto steepest = std::max_element(slope.begin(), slope.end());
    auto i = static_cast<std::size_t>(steepest - slope.begin());
    while (i > kReach && slope[i] > kShare * *steepest) {
        --i;
    }
    return i > kReach ? std::optional(branch.base[i]) : std::nullopt;
}

}  // namespace

std::optional<double> contactPoint(ContactMethod method, const BranchSamples& approach,
                                   const std::vector<double>& force, double noise,
                                   double exponent) {
    if (method == ContactMethod::Deviation) {
        return byDeviation(approach, force, noise);
    }
    const ThinnedBranch branch = thinned(approach, force);
    const std::size_t peak = branch.peak();
    switch (method) {
    case ContactMethod::LinePower:
        return bestBreak(branch, [&](double x) {
            return squaresAbout(branch, peak, x, true, exponent > 1.75 ? 2.0 : 1.5);
        });
    case ContactMethod::ConstantLine:
        return bestBreak(branch,
                         [&](double x) { return squaresAbout(branch, peak, x, false, 1.0); });
    case ContactMethod::Gradient:
        return byGradient(branch);
    default:
        return std::nullopt;
    }
}

}  // namespace asperity
