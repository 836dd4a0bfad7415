#include "core/fidelity/SurfaceNeeds.h"

#include "core/scene/ContactPatch.h"
#include "core/scene/HalfSpaceModel.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

constexpr int kSamples = 65;
constexpr double kReach = 3.0;  // of a patch, in contact radii
constexpr std::size_t kMoments = 3;

/// Contacts that differ, the one with the largest normal force first.
std::vector<const TipState*> moments(std::span<const TipState> states) {
    std::vector<const TipState*> bonded;
    for (const TipState& state : states) {
        if (state.converged && state.contact.contactRadius > 0.0) {
            bonded.push_back(&state);
        }
    }
    std::ranges::stable_sort(bonded, std::greater(),
                             [](const TipState* state) { return state->normalForce; });
    std::vector<const TipState*> chosen;
    for (std::size_t i = 0; i < kMoments && i < bonded.size(); ++i) {
        chosen.push_back(bonded[i * (bonded.size() - 1) / kMoments]);
    }
    return chosen;
}

struct TimedPatch {
    SurfacePatch patch;
    double time = 0.0;  ///< [s]
};

TimedPatch timedPatch(const Scene& scene, const TipState& state, DeformationTier tier) {
    using Clock = std::chrono::steady_clock;
    const PatchGrid grid{.halfWidth = kReach * state.contact.contactRadius, .samples = kSamples};
    const auto start = Clock::now();
    SurfacePatch patch = contactPatch(scene, state, tier, grid);
    return {std::move(patch), std::chrono::duration<double>(Clock::now() - start).count()};
}

/// Root mean square of the distance between the patches' points [m].
double rmsDistance(const SurfacePatch& a, const SurfacePatch& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        sum += (a.points[i] - b.points[i]).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(a.points.size()));
}

}  // namespace

SurfaceNeeds surfaceNeedsOf(const Scene& scene, std::span<const TipState> states) {
    SurfaceNeeds needs;
    for (const TipState* state : moments(states)) {
        const TimedPatch radius = timedPatch(scene, *state, DeformationTier::ContactRadius);
        const TimedPatch closed = timedPatch(scene, *state, DeformationTier::ClosedForm);
        const double depth = std::abs(state->contact.indentation);
        const auto share = [depth](double distance) {
            return depth > 0.0 ? distance / depth : 0.0;
        };
        needs.outside = std::max(needs.outside, share(rmsDistance(radius.patch, closed.patch)));
        needs.outsideTime = closed.time - radius.time;
        const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, *state);
        if (!needs.touches) {
            needs.halfSpaceWord = sentenceOf(answer);
        }
        needs.halfSpaceHolds = answer.valid() && (!needs.touches || needs.halfSpaceHolds);
        needs.touches = true;
        if (answer.valid()) {
            const TimedPatch solved = timedPatch(scene, *state, DeformationTier::HalfSpace);
            needs.halfSpace =
                std::max(needs.halfSpace, share(rmsDistance(closed.patch, solved.patch)));
            needs.halfSpaceTime = solved.time - closed.time;
        }
    }
    return needs;
}

}  // namespace asperity
