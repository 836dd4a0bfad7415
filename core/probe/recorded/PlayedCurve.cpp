#include "core/probe/recorded/PlayedCurve.h"

#include "core/Error.h"
#include "core/curves/AlignedForceCurve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kAtSample = 1e-6;     ///< of the mean way between samples: a base is at one
constexpr double kSnapInSigmas = 5.0;  ///< standard deviations: the sample pulls

/// The place of a value between a sample and the next.
/// @param slack within which it is at one of them
std::optional<BranchPlace> between(const std::vector<double>& values, std::size_t sample,
                                   double wanted, double slack) noexcept {
    const double from = values[sample];
    const double to = values[sample + 1];
    if (std::abs(wanted - to) <= slack) {
        return BranchPlace{sample + 1, 0.0};
    }
    if (std::abs(wanted - from) <= slack) {
        return BranchPlace{sample, 0.0};
    }
    if ((wanted > from) == (wanted > to)) {
        return std::nullopt;
    }
    return BranchPlace{sample, (wanted - from) / (to - from)};
}

double valueAt(const std::vector<double>& values, const BranchPlace& place) noexcept {
    return place.share == 0.0
               ? values[place.sample]
               : std::lerp(values[place.sample], values[place.sample + 1], place.share);
}

void takeForces(MeasuredForceCurve& curve, double stiffness) {
    for (CurveSegment& segment : curve.segments) {
        if (segment.force.empty() && !segment.deflection.empty()) {
            if (!(stiffness > 0.0)) {
                throw Error("the curve says deflections and no stiffness of its lever: "
                            "curve_stiffness_n_m of [truth] gives it");
            }
            for (const double deflection : segment.deflection) {
                segment.force.push_back(stiffness * deflection);
            }
        }
    }
}

/// Distance at which the approach pulls most on its way to the contact; 0: nowhere beyond noise.
double touchOf(const AlignedForceCurve& aligned) {
    const std::vector<double>& force = aligned.approach.force;
    auto i = static_cast<std::size_t>(std::ranges::max_element(force) - force.begin());
    while (i > 0 && force[i] > 0.0) {
        --i;
    }
    std::size_t strongest = i;
    for (; i > 0 && force[i] <= 0.0; --i) {
        strongest = force[i] < force[strongest] ? i : strongest;
    }
    return force[strongest] < -kSnapInSigmas * aligned.noise
               ? std::max(0.0, aligned.approach.baseDistance[strongest])
               : 0.0;
}

double meanWay(const std::vector<double>& distance) {
    const auto [nearest, farthest] = std::ranges::minmax_element(distance);
    return (*farthest - *nearest) / static_cast<double>(distance.size());
}

/// All samples in order, the retract above the approach's baseline.
PlayedBranch allOf(const AlignedForceCurve& aligned) {
    PlayedBranch all{.distance = aligned.approach.baseDistance, .force = aligned.approach.force};
    const AlignedBranch& retract = aligned.retract;
    all.distance.insert(all.distance.end(), retract.baseDistance.begin(),
                        retract.baseDistance.end());
    for (const double force : retract.force) {
        all.force.push_back(force + aligned.retractOffset);
    }
    all.slack = kAtSample * meanWay(all.distance);
    return all;
}

}  // namespace

double PlayedBranch::distanceAt(const BranchPlace& place) const noexcept {
    return valueAt(distance, place);
}

double PlayedBranch::forceAt(const BranchPlace& place) const noexcept {
    return valueAt(force, place);
}

std::optional<BranchPlace> PlayedBranch::first(double wanted) const noexcept {
    return std::abs(wanted - distance.front()) <= slack ? BranchPlace{} : ahead({}, wanted);
}

std::optional<BranchPlace> PlayedBranch::next(const BranchPlace& from,
                                              double wanted) const noexcept {
    if (from.sample + 1 >= distance.size()) {
        return std::abs(wanted - distance.back()) <= slack ? std::optional(end()) : std::nullopt;
    }
    const std::optional<BranchPlace> found = between(distance, from.sample, wanted, slack);
    if (found && *found >= from) {
        return found;
    }
    return std::abs(wanted - distanceAt(from)) <= slack ? std::optional(from) : std::nullopt;
}

std::optional<BranchPlace> PlayedBranch::ahead(const BranchPlace& from,
                                               double wanted) const noexcept {
    std::optional<BranchPlace> found = next(from, wanted);
    for (std::size_t i = from.sample + 1; !found && i + 1 < distance.size(); ++i) {
        found = between(distance, i, wanted, slack);
    }
    return found;
}

std::optional<BranchPlace> PlayedBranch::behind(const BranchPlace& from,
                                                double wanted) const noexcept {
    std::optional<BranchPlace> found;
    for (std::size_t i = std::min(from.sample + 1, distance.size() - 1); !found && i > 0; --i) {
        found = between(distance, i - 1, wanted, slack);
    }
    return found;
}

std::optional<BranchPlace> PlayedBranch::withForce(double wanted) const noexcept {
    if (force.front() == wanted) {
        return BranchPlace{};
    }
    std::optional<BranchPlace> found;
    for (std::size_t i = 0; !found && i + 1 < force.size(); ++i) {
        found = between(force, i, wanted, 0.0);
    }
    return found;
}

std::shared_ptr<const PlayedCurve> playedCurve(MeasuredForceCurve curve, double stiffness) {
    const double lever = curve.stiffness > 0.0 ? curve.stiffness : stiffness;
    takeForces(curve, lever);
    const AlignedForceCurve aligned = alignedCurve(curve, lever);
    if (!(aligned.stiffness > 0.0)) {
        throw Error("the curve does not say the stiffness of its lever: curve_stiffness_n_m of "
                    "[truth] gives it");
    }
    if (aligned.retract.force.empty()) {
        throw Error("the curve has no retract: nothing says what follows where the base turns");
    }
    const PlayedBranch all = allOf(aligned);
    const auto deepest = std::ranges::min_element(all.distance) - all.distance.begin();
    auto played = std::make_shared<PlayedCurve>();
    played->approach = {.distance = {all.distance.begin(), all.distance.begin() + deepest + 1},
                        .force = {all.force.begin(), all.force.begin() + deepest + 1},
                        .slack = all.slack};
    played->retract = {.distance = {all.distance.begin() + deepest, all.distance.end()},
                       .force = {all.force.begin() + deepest, all.force.end()},
                       .slack = all.slack};
    played->touch = touchOf(aligned);
    if (!(all.distance.front() > played->touch)) {
        throw Error("the approach of this curve begins where the sample already pulls");
    }
    played->free = aligned.lastPull;
    played->stiffness = aligned.stiffness;
    if (!(std::ranges::max(played->retract.distance) > played->free)) {
        throw Error("the retract of this curve ends before the tip comes free");
    }
    return played;
}

}  // namespace asperity
