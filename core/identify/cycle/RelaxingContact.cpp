#include "core/identify/cycle/RelaxingContact.h"

#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

/// (1 - exp(-x)) / x for x >= 0.
double meanDecay(double x) noexcept { return x > 0.0 ? -std::expm1(-x) / x : 1.0; }

/// Elastic force of the unit sphere over its paraboloid's at indentations up to the radius: cubic
/// between values and slopes of SneddonLaw, to 1e-9, at a tenth of its cost.
class SphereShare {
public:
    static constexpr double kDeepest = 1.0;

    SphereShare() noexcept {
        const SneddonLaw law({.tipRadius = 1.0, .reducedModulus = 1.0});
        nodes_[0] = {1.0, -0.1 * kStep};
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            const double depth = kStep * static_cast<double>(i);
            const LawPoint point = law.stable(depth, 0.0).value_or(LawPoint{});
            const double paraboloid = 4.0 / 3.0 * depth * std::sqrt(depth);
            const double share = point.force / paraboloid;
            nodes_[i] = {share, kStep * ((point.stiffness / paraboloid) - (1.5 * share / depth))};
        }
    }

    struct Value {
        double share = 0.0;
        double rate = 0.0;  ///< by the indentation
    };
    /// @param depth 0 .. kDeepest
    [[nodiscard]] Value at(double depth) const noexcept {
        const std::size_t cell =
            std::min(static_cast<std::size_t>(depth / kStep), nodes_.size() - 2);
        const double x = (depth / kStep) - static_cast<double>(cell);
        const Node& low = nodes_[cell];
        const Node& high = nodes_[cell + 1];
        const double rise = high.share - low.share;
        const double square = (3.0 * rise) - (2.0 * low.slope) - high.slope;
        const double cube = low.slope + high.slope - (2.0 * rise);
        return {low.share + (x * (low.slope + (x * (square + (x * cube))))),
                (low.slope + (x * ((2.0 * square) + (3.0 * x * cube)))) / kStep};
    }

private:
    struct Node {
        double share = 0.0;
        double slope = 0.0;  ///< over a cell
    };
    static constexpr std::size_t kCells = 128;
    static constexpr double kStep = kDeepest / static_cast<double>(kCells);

    std::array<Node, kCells + 1> nodes_;
};

/// Any root of an increasing function near `guess`.
template <typename Function>
double rootNear(const Function& function, double guess, double reach) noexcept {
    constexpr int kMaxDoublings = 60;
    const double sign = function(guess) > 0.0 ? -1.0 : 1.0;
    double far = guess + (sign * reach);
    for (int i = 0; i < kMaxDoublings && sign * function(far) < 0.0; ++i) {
        reach *= 2.0;
        far = guess + (sign * reach);
    }
    return rootBetween(function, std::min(guess, far), std::max(guess, far));
}

}  // namespace

RelaxingContact::RelaxingContact(const RelaxingParameters& parameters, std::size_t samples)
    : parameters_(parameters)
    , plane_(1.0 - (parameters.poissonRatio * parameters.poissonRatio))
    , sphere_({.tipRadius = parameters.tipRadius, .reducedModulus = 1.0}) {
    history_.reserve(samples);
}

void RelaxingContact::load(Sample& sample) const noexcept {
    if (!(sample.indentation > 0.0)) {
        return;
    }
    const double radius = std::sqrt(parameters_.tipRadius * sample.indentation);
    sample.load = 4.0 / 3.0 * radius * sample.indentation;
    sample.loadRate = 2.0 * radius;
    if (!parameters_.sphere) {
        return;
    }
    const double depth = sample.indentation / parameters_.tipRadius;
    if (depth > SphereShare::kDeepest) {
        const LawPoint point = sphere_.stable(sample.indentation, 0.0).value_or(LawPoint{});
        sample.load = point.force;
        sample.loadRate = point.stiffness;
        return;
    }
    static const SphereShare shares;
    const auto [share, rate] = shares.at(depth);
    sample.loadRate = (sample.loadRate * share) + (sample.load * rate / parameters_.tipRadius);
    sample.load *= share;
}

RelaxingContact::Sample RelaxingContact::after(const Sample& before, double time,
                                               double indentation) const noexcept {
    const double elapsed = std::max(time - before.time, 0.0) / parameters_.relaxationTime;
    const double decay = std::exp(-elapsed);
    const double mean = meanDecay(elapsed);
    Sample sample{.time = time, .indentation = indentation};
    load(sample);
    sample.loadMemory = (before.loadMemory * decay) + ((sample.load - before.load) * mean);
    sample.wayMemory = (before.wayMemory * decay) + ((indentation - before.indentation) * mean);
    return sample;
}

/// The stress that the way since `then` has left at the edge that the contact had: >= 0 where it is
/// as wide now.
double RelaxingContact::excess(const Sample& then, const Sample& now) const noexcept {
    const double decay = std::exp((then.time - now.time) / parameters_.relaxationTime);
    return (parameters_.longModulus * (now.indentation - then.indentation)) +
           (parameters_.relaxingModulus * (now.wayMemory - (decay * then.wayMemory)));
}

/// Number of the samples, up to the widest, after which the contact was as wide as now; 0: none.
std::size_t RelaxingContact::asWide(const Sample& now) const noexcept {
    std::size_t count = widest_ + 1;
    while (count > 0 && excess(history_[count - 1], now) < 0.0) {
        --count;
    }
    return count;
}

/// Of the contact. @param count as asWide() has it
double RelaxingContact::forceOf(const Sample& now, std::size_t count) const noexcept {
    const auto force = [&](const Sample& last) {
        const double decay = std::exp((last.time - now.time) / parameters_.relaxationTime);
        return ((parameters_.longModulus * last.load) +
                (parameters_.relaxingModulus * decay * last.loadMemory)) /
               plane_;
    };
    if (count == 0) {
        return 0.0;
    }
    if (count == widest_ + 1) {
        if (count == history_.size() || now.indentation >= deepest_) {
            return force(now);
        }
        const Sample& last = history_[widest_];
        return force(last) + (last.loadRate * excess(last, now) / plane_);
    }
    const Sample& before = history_[count - 1];
    const Sample& beyond = history_[count];
    const double first = excess(before, now);
    const double share = first / (first - excess(beyond, now));
    return force(after(before, before.time + (share * (beyond.time - before.time)),
                       before.indentation + (share * (beyond.indentation - before.indentation))));
}

/// None between samples of the same time.
double RelaxingContact::dragAt(double time, double indentation) const noexcept {
    const Sample& before = history_.back();
    const double elapsed = time - before.time;
    const double speed = elapsed > 0.0 ? (indentation - before.indentation) / elapsed : 0.0;
    return parameters_.drag * speed / (std::max(-indentation, 0.0) + parameters_.dragOffset);
}

double RelaxingContact::forceAt(double time, double indentation) const noexcept {
    if (history_.empty()) {
        return 0.0;
    }
    const Sample now = after(history_.back(), time, indentation);
    return forceOf(now, asWide(now)) + dragAt(time, indentation);
}

double RelaxingContact::advance(double time, double indentation) {
    if (history_.empty()) {
        history_.push_back({.time = time, .indentation = indentation});
        deepest_ = indentation;
        return 0.0;
    }
    const Sample now = after(history_.back(), time, indentation);
    const std::size_t count = asWide(now);
    const double force = forceOf(now, count) + dragAt(time, indentation);
    const bool grows = count == widest_ + 1;
    const bool loads = count == history_.size() || indentation >= deepest_;
    history_.push_back(now);
    if (grows && loads) {
        widest_ = history_.size() - 1;
    } else if (!grows) {
        widest_ = count;
    }
    deepest_ = std::max(deepest_, indentation);
    return force;
}

std::vector<double> relaxingForces(const RelaxingParameters& parameters,
                                   const std::vector<double>& times,
                                   const std::vector<double>& indentations) {
    RelaxingContact contact(parameters, times.size());
    std::vector<double> forces(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        forces[i] = contact.advance(times[i], indentations[i]);
    }
    if (forces.size() > 1) {
        forces[0] = forces[1];  // the first sample has no speed
    }
    return forces;
}

std::vector<double> simulatedForces(const RelaxingParameters& parameters, double stiffness,
                                    const std::vector<double>& times,
                                    const std::vector<double>& bases) {
    RelaxingContact contact(parameters, times.size());
    std::vector<double> forces(times.size());
    double indentation = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double approach = bases[i] - parameters.contactPoint;
        if (i == 0) {
            indentation = approach;
        } else {
            const double step = bases[i] - bases[i - 1];
            const auto unbalanced = [&](double depth) {
                return contact.forceAt(times[i], depth) - (stiffness * (approach - depth));
            };
            indentation = rootNear(unbalanced, indentation + step, std::abs(step) + 1e-30);
        }
        contact.advance(times[i], indentation);
        forces[i] = stiffness * (approach - indentation);
    }
    return forces;
}

}  // namespace asperity
