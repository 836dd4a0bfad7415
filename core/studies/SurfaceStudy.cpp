#include "core/studies/SurfaceStudy.h"

#include "core/deformation/ContactPatch.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/fidelity/ModelRun.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace asperity {

namespace {

constexpr int kReferenceSamples = 193;  // of a patch, a side
constexpr double kReach = 3.0;          // of a patch, in contact radii

/// Contacts of the run, spread evenly.
std::vector<TipState> contactsOf(std::span<const TipState> states, int count) {
    std::vector<TipState> bonded;
    std::ranges::copy_if(states, std::back_inserter(bonded), [](const TipState& state) {
        return state.converged && state.contact.contactRadius > 0.0;
    });
    std::vector<TipState> chosen;
    for (int i = 0; i < count && !bonded.empty(); ++i) {
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        chosen.push_back(
            bonded[static_cast<std::size_t>(share * static_cast<double>(bonded.size() - 1))]);
    }
    return chosen;
}

PatchGrid gridOf(const TipState& state, int samples) {
    return {.halfWidth = kReach * state.contact.contactRadius, .samples = samples};
}

/// Displacement along z of a patch at a place of its grid, 0..1 along each side, between the
/// samples as a picture shows it [m].
double displacementAt(const SurfacePatch& patch, double column, double row) {
    const double x = column * (patch.columns - 1);
    const double y = row * (patch.rows - 1);
    const int j = std::min(static_cast<int>(x), patch.columns - 2);
    const int i = std::min(static_cast<int>(y), patch.rows - 2);
    const auto at = [&](int r, int c) {
        const std::size_t index = patch.index(r, c);
        return patch.points[index].z() - patch.rest[index].z();
    };
    const double low = std::lerp(at(i, j), at(i, j + 1), x - j);
    const double high = std::lerp(at(i + 1, j), at(i + 1, j + 1), x - j);
    return std::lerp(low, high, y - i);
}

/// Sums up differences of patches.
struct SurfaceError {
    double sum = 0.0;
    double largest = 0.0;
    std::size_t count = 0;

    void add(const SurfacePatch& patch, const SurfacePatch& reference) {
        for (int row = 0; row < reference.rows; ++row) {
            for (int column = 0; column < reference.columns; ++column) {
                const double x = static_cast<double>(column) / (reference.columns - 1);
                const double y = static_cast<double>(row) / (reference.rows - 1);
                const double error = displacementAt(patch, x, y) - displacementAt(reference, x, y);
                sum += error * error;
                largest = std::max(largest, std::abs(error));
                ++count;
            }
        }
    }
    [[nodiscard]] double rms() const {
        return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
    }
};

/// The half-space's patches, and the contacts that they are of: those where it holds.
struct SolvedContacts {
    std::vector<TipState> states;
    std::vector<SurfacePatch> patches;
    double forceError = 0.0;  ///< of the law against its own force, root mean square [N]
};

/// @param pixels of the half-space, a side
SolvedContacts solvedContacts(const Scene& scene, const std::vector<TipState>& states, int pixels) {
    SolvedContacts solved;
    double sum = 0.0;
    HalfSpaceModel model(pixels, {.tolerance = 1e-4});
    for (const TipState& state : states) {
        const HalfSpaceAnswer answer = model.solve(scene, state);
        if (answer.valid()) {
            solved.states.push_back(state);
            const double error = answer.force - state.normalForce;
            sum += error * error;
            solved.patches.push_back(
                halfSpacePatch(scene, answer, gridOf(state, kReferenceSamples)));
        }
    }
    if (!solved.states.empty()) {
        solved.forceError = std::sqrt(sum / static_cast<double>(solved.states.size()));
    }
    return solved;
}

/// Where no half-space holds the closed form is all there is to compare with.
SolvedContacts closedForms(const Scene& scene, const std::vector<TipState>& states) {
    SolvedContacts closed{.states = states, .patches = {}};
    for (const TipState& state : states) {
        closed.patches.push_back(exactPatch(scene, state, DeformationModel::ClosedForm,
                                            gridOf(state, kReferenceSamples)));
    }
    return closed;
}

FrameResult resultOf(const Scene& scene, const FrameOptions& options,
                     const SolvedContacts& reference, int rounds) {
    const std::vector<TipState>& states = reference.states;
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    SurfaceError error;
    for (std::size_t i = 0; i < states.size(); ++i) {
        SurfacePatch patch;
        for (int round = 0; round < rounds; ++round) {
            const auto start = Clock::now();
            patch = exactPatch(scene, states[i], options.deformation,
                               gridOf(states[i], options.samples));
            times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        }
        error.add(patch, reference.patches[i]);
    }
    return {.options = options,
            .median = quantile(times, 0.5),
            .surfaceErrorRms = error.rms(),
            .surfaceErrorMax = error.largest};
}

/// How much the half-space still changes with its pixels.
void doubt(const Scene& scene, const SolvedContacts& reference, TradeOffReference& result) {
    const SolvedContacts coarser =
        solvedContacts(scene, reference.states, HalfSpaceModel::kSamples);
    if (coarser.states.size() != reference.states.size()) {
        result.surfaceDoubtBy = SurfaceDoubt::CoarserFails;
        return;
    }
    SurfaceError error;
    for (std::size_t i = 0; i < reference.patches.size(); ++i) {
        error.add(coarser.patches[i], reference.patches[i]);
    }
    result.surfaceDoubt = error.rms();
    result.surfaceDoubtBy = SurfaceDoubt::ByCoarser;
}

double rmsIndentation(const std::vector<TipState>& states) {
    double sum = 0.0;
    for (const TipState& state : states) {
        sum += state.contact.indentation * state.contact.indentation;
    }
    return states.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(states.size()));
}

}  // namespace

void studySurfaces(const Scene& scene, std::span<const TipState> states, const TradeOffPlan& plan,
                   Progress* progress, TradeOff& result) {
    constexpr int kFinePixels = 2 * HalfSpaceModel::kSamples;
    const std::vector<TipState> contacts = contactsOf(states, plan.patches);
    reportTo(progress, 0.0);
    SolvedContacts reference = solvedContacts(scene, contacts, kFinePixels);
    const bool holds = !reference.states.empty();
    if (holds) {
        doubt(scene, reference, result.reference);
    } else {
        reference = closedForms(scene, contacts);
        result.reference.surfaceDoubtBy = SurfaceDoubt::NothingFiner;
    }
    result.reference.halfSpaceForce = reference.forceError;
    result.reference.contacts = static_cast<int>(reference.states.size());
    result.reference.contactsAsked = static_cast<int>(contacts.size());
    result.reference.frame = {.deformation = holds ? DeformationModel::HalfSpace
                                                   : DeformationModel::ClosedForm,
                              .samples = kReferenceSamples};
    result.reference.indentation = rmsIndentation(reference.states);
    const std::vector<FrameOptions> all = frameOptions();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const FrameOptions& options = all[i];
        reportTo(progress, static_cast<double>(i + 1) / static_cast<double>(all.size() + 1));
        if (holds || options.deformation != DeformationModel::HalfSpace) {
            result.frames.push_back(resultOf(scene, options, reference, plan.rounds));
        }
    }
}

}  // namespace asperity
