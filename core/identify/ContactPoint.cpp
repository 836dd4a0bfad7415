#include "core/identify/ContactPoint.h"

#include "core/identify/LeastSquares.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
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
    constexpr std::size_t kWindows = 400;
    const auto peak =
        static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
    // Three samples at least: one that stands out is no contact.
    const std::size_t half = std::max<std::size_t>(1, approach.size() / (2 * kWindows));
    const double width = static_cast<double>((2 * half) + 1);
    if (peak <= 2 * half || !(force[peak] > kDeparture * noise)) {
        return std::nullopt;
    }
    std::size_t i = peak - half;
    double sum = 0.0;
    for (std::size_t j = i - half; j <= i + half; ++j) {
        sum += force[j];
    }
    if (!(sum / width > kDeparture * noise)) {
        return std::nullopt;
    }
    while (i > half && sum / width > kDeparture * noise) {
        --i;
        sum += force[i - half] - force[i + half + 1];
    }
    return i > half ? std::optional(approach.base[i]) : std::nullopt;
}

/// Returns where, between the second sample and the peak, the sum of squares of a model is least.
std::optional<double> bestBreak(const ThinnedBranch& branch,
                                const std::function<double(double)>& squares) {
    const std::size_t peak = branch.peak();
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 2; i + 4 < peak; ++i) {
        const double found = squares(branch.base[i]);
        if (found < least) {
            least = found;
            best = i;
        }
    }
    // At an end of the data the contact is outside of it.
    return best > 2 && best + 5 < peak ? std::optional(branch.base[best]) : std::nullopt;
}

/// Sum of squares about c0 + c1 * before(x) + c2 * after(x), c0 .. c2 fitted.
double squaresAbout(const ThinnedBranch& branch, double contact, bool tilted, double exponent) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double total = 0.0;
    const double scale = branch.base[branch.peak()] - contact;
    for (std::size_t i = 0; i <= branch.peak(); ++i) {
        const double x = (branch.base[i] - contact) / scale;
        const double power = exponent == 1.0 ? x : std::pow(std::max(0.0, x), exponent);
        const Eigen::Vector3d row(1.0, tilted ? x : 0.0, x > 0.0 ? power : 0.0);
        normal += row * row.transpose();
        right += branch.force[i] * row;
        total += branch.force[i] * branch.force[i];
    }
    if (!tilted) {
        normal(1, 1) = 1.0;
    }
    return total - right.dot(normal.ldlt().solve(right));
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
    switch (method) {
    case ContactMethod::LinePower:
        return bestBreak(branch, [&](double x) { return squaresAbout(branch, x, true, exponent); });
    case ContactMethod::ConstantLine:
        return bestBreak(branch, [&](double x) { return squaresAbout(branch, x, false, 1.0); });
    case ContactMethod::Gradient:
        return byGradient(branch);
    default:
        return std::nullopt;
    }
}

}  // namespace asperity
