#include "core/fidelity/SurfaceNeeds.h"

#include "core/deformation/ContactPatch.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/fidelity/ModelRun.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr int kSamples = 65;
constexpr double kReach = 3.0;  // of a patch, in contact radii
constexpr std::size_t kMoments = 3;
constexpr int kRounds = 3;  // of timed patches

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

double rms(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value * value;
    }
    return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

/// What it makes, and the shortest time that this takes of a few rounds [s].
template <class Make>
auto timed(int rounds, const Make& make) {
    using Clock = std::chrono::steady_clock;
    double shortest = std::numeric_limits<double>::infinity();
    decltype(make()) made;
    for (int round = 0; round < rounds; ++round) {
        const auto start = Clock::now();
        made = make();
        shortest = std::min(shortest, std::chrono::duration<double>(Clock::now() - start).count());
    }
    return std::pair(std::move(made), shortest);
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

SurfaceNeeds surfaceNeedsOf(const Scene& scene, std::span<const TipState> states,
                            Progress* progress) {
    HalfSpaceModel halfSpace;
    SurfaceNeeds needs;
    std::vector<double> outside;
    std::vector<double> halfSpaces;
    std::vector<double> outsideTimes;
    std::vector<double> solveTimes;
    for (const TipState* state : moments(states)) {
        const PatchGrid grid{.halfWidth = kReach * state->contact.contactRadius,
                             .samples = kSamples};
        const auto patch = [&](DeformationModel model) {
            return timed(kRounds, [&] { return exactPatch(scene, *state, model, grid); });
        };
        const double depth = std::abs(state->contact.indentation);
        const auto share = [depth](double distance) {
            return depth > 0.0 ? distance / depth : 0.0;
        };
        const double done = static_cast<double>(outside.size()) / kMoments;
        reportTo(progress, done);
        const auto [radius, radiusTime] = patch(DeformationModel::ContactRadius);
        const auto [closed, closedTime] = patch(DeformationModel::ClosedForm);
        outside.push_back(share(rmsDistance(radius, closed)));
        outsideTimes.push_back(closedTime - radiusTime);
        reportTo(progress, done + 0.5 / kMoments);
        const auto [answer, solveTime] = timed(1, [&] { return halfSpace.solve(scene, *state); });
        if (!needs.touches) {
            needs.deepest = answer;
        }
        needs.halfSpaceHolds = answer.valid() && (!needs.touches || needs.halfSpaceHolds);
        needs.touches = true;
        if (answer.valid()) {
            const SurfacePatch solved = halfSpacePatch(scene, answer, grid);
            halfSpaces.push_back(share(rmsDistance(closed, solved)));
            solveTimes.push_back(solveTime);
        }
    }
    needs.outsideTime = quantile(outsideTimes, 0.5);
    needs.halfSpaceTime = quantile(std::move(solveTimes), 0.0);  // the first one sets up as well
    needs.outside = rms(outside);
    needs.halfSpace = rms(halfSpaces);
    return needs;
}

}  // namespace asperity
