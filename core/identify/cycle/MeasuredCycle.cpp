#include "core/identify/cycle/MeasuredCycle.h"

#include "core/Error.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kSignificant = 6.0;  // times the noise
/// Steps next to a jump belong to it while they are larger than this share of its largest step.
constexpr double kStepOfJump = 0.05;

std::size_t positionOf(const std::vector<double>& values,
                       std::vector<double>::const_iterator position) {
    return static_cast<std::size_t>(position - values.begin());
}

/// The largest step of this sign between neighboring samples of [from, to), with the smaller ones
/// about it.
std::optional<MeasuredJump> largestJump(const CycleBranch& branch, std::size_t from, std::size_t to,
                                        double sign, double noise) {
    const auto step = [&](std::size_t i) { return sign * (branch.force[i] - branch.force[i - 1]); };
    std::size_t largest = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
        largest = largest == 0 || step(i) > step(largest) ? i : largest;
    }
    if (largest == 0 || step(largest) < kSignificant * noise) {
        return std::nullopt;
    }
    const double least = std::max(kStepOfJump * step(largest), kSignificant / 2.0 * noise);
    std::size_t before = largest - 1;
    while (before > from && step(before) > least) {
        --before;
    }
    std::size_t after = largest;
    while (after + 1 < to && step(after + 1) > least) {
        ++after;
    }
    return MeasuredJump{before, after, 0.5 * (branch.base[largest - 1] + branch.base[largest])};
}

/// First sample from which on the approach stays above the noise.
std::size_t firstRise(const CycleBranch& approach, double noise) {
    const auto quiet =
        std::find_if(approach.force.rbegin(), approach.force.rend(),
                     [&](double force) { return force < kSignificant / 2.0 * noise; });
    return static_cast<std::size_t>(approach.force.rend() - quiet);
}

void findSnapIn(const MeasuredCycle& cycle, CycleEvents& events) {
    const std::vector<double>& force = cycle.approach.force;
    const std::size_t top = positionOf(force, std::max_element(force.begin(), force.end()));
    const std::size_t lowest = positionOf(
        force, std::min_element(force.begin(), force.begin() + static_cast<std::ptrdiff_t>(top)));
    events.contactBegin = firstRise(cycle.approach, cycle.noise);
    if (force[lowest] > -kSignificant * cycle.noise) {
        return;
    }
    events.snapIn = largestJump(cycle.approach, 0, lowest + 1, -1.0, cycle.noise);
    events.contactBegin = events.snapIn ? events.snapIn->after : lowest;
}

void findPullOff(const MeasuredCycle& cycle, CycleEvents& events) {
    const std::vector<double>& force = cycle.retract.force;
    const std::size_t lowest = positionOf(force, std::min_element(force.begin(), force.end()));
    events.lowestForce = force[lowest];
    events.attracts = force[lowest] < -kSignificant * cycle.noise;
    if (!events.attracts) {
        const auto quiet = std::find_if(force.begin(), force.end(), [&](double value) {
            return value < kSignificant / 2.0 * cycle.noise;
        });
        events.contactEnd = positionOf(force, quiet);
        return;
    }
    events.pullOff = largestJump(cycle.retract, lowest, force.size(), 1.0, cycle.noise);
    events.contactEnd = (events.pullOff ? events.pullOff->before : lowest) + 1;
}

double meanOf(const std::vector<double>& values, std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t i = from; i < to; ++i) {
        sum += values[i];
    }
    return sum / static_cast<double>(to - from);
}

}  // namespace

double MeasuredCycle::forceRange() const noexcept {
    double low = 0.0;
    double high = 0.0;
    for (const CycleBranch* branch : {&approach, &retract}) {
        for (const double force : branch->force) {
            low = std::min(low, force);
            high = std::max(high, force);
        }
    }
    return high - low;
}

CycleEvents cycleEvents(const MeasuredCycle& cycle) {
    if (cycle.approach.size() < 2 || cycle.retract.size() < 2) {
        throw Error("a cycle needs an approach and a retract");
    }
    CycleEvents events;
    findSnapIn(cycle, events);
    findPullOff(cycle, events);
    if (events.contactBegin + 2 > cycle.approach.size() || events.contactEnd < 2) {
        throw Error("the cycle has no samples in contact");
    }
    return events;
}

CycleBranch binned(const CycleBranch& branch, std::size_t from, std::size_t to, std::size_t bins) {
    const std::size_t count = std::min(bins, to - from);
    CycleBranch samples;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = from + (i * (to - from) / count);
        const std::size_t end = from + ((i + 1) * (to - from) / count);
        samples.base.push_back(meanOf(branch.base, begin, end));
        samples.force.push_back(meanOf(branch.force, begin, end));
        if (!branch.time.empty()) {
            samples.time.push_back(meanOf(branch.time, begin, end));
        }
    }
    return samples;
}

double contactSlope(const CycleBranch& samples) {
    const auto [low, high] = std::minmax_element(samples.force.begin(), samples.force.end());
    const double half = std::max(0.5 * (*low + *high), 0.5 * *high);
    double count = 0.0;
    double base = 0.0;
    double force = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.force[i] >= half) {
            count += 1.0;
            base += samples.base[i];
            force += samples.force[i];
        }
    }
    double square = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.force[i] >= half) {
            const double offset = samples.base[i] - (base / count);
            square += offset * offset;
            product += offset * (samples.force[i] - (force / count));
        }
    }
    return product / square;
}

}  // namespace asperity
