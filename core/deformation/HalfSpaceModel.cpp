#include "core/deformation/HalfSpaceModel.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/HalfSpaceField.h"
#include "core/deformation/HalfSpaceProblem.h"
#include "core/scene/Scene.h"
#include "core/surface/PixelField.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

// In radii of the law's contact with its cohesive zone: half the width of a new patch, and that of
// one that may stay.
constexpr double kRoom = 2.5;
constexpr double kMinRoom = 1.8;
constexpr double kMaxRoom = 4.0;
constexpr double kWiden = 1.6;          // where the contact on real topography is wider
constexpr double kMaxPatchWidth = 2.0;  // half width in tip radii
constexpr double kSeveralPointsRoom =
    1.0;  // in tip radii: other closest points may lie so far away

/// Whether the law's adhesion has no range that a half-space could take for its own: JKR's has
/// none, DMT's reaches everywhere.
bool adheresWithoutZone(const ContactModel& model) {
    const bool adhesive =
        isAdhesive(model.law()) && traitsOf(model.law()).attraction != Attraction::Zone;
    return adhesive && model.pair().workOfAdhesion >= kMinAdhesion;
}

HalfSpaceVerdict askable(const Scene& scene, const TipState& state) {
    const ContactState& contact = state.contact;
    if (contact.branch != ContactBranch::Bonded || !(contact.cohesiveRadius > 0.0)) {
        return HalfSpaceVerdict::NotBonded;
    }
    if (isFilm(scene.belief.contact.law())) {
        return HalfSpaceVerdict::Film;
    }
    return adheresWithoutZone(scene.belief.contact) ? HalfSpaceVerdict::NoZone
                                                    : HalfSpaceVerdict::Valid;
}

HalfSpaceVerdict verdictOn(const HalfSpaceSolution& solution) {
    switch (solution.status) {
    case HalfSpaceStatus::Canceled:
        return HalfSpaceVerdict::Canceled;
    case HalfSpaceStatus::NotConverged:
        return HalfSpaceVerdict::NotConverged;
    case HalfSpaceStatus::Converged:
        break;
    }
    if (solution.doubts.largeContact) {
        return HalfSpaceVerdict::LargeContact;
    }
    if (solution.doubts.reachesBorder) {
        return HalfSpaceVerdict::ReachesBorder;
    }
    if (solution.doubts.tooCoarse) {
        return HalfSpaceVerdict::TooCoarse;
    }
    return solution.cohesiveRadius > 0.0 ? HalfSpaceVerdict::Valid : HalfSpaceVerdict::Separate;
}

std::shared_ptr<const HalfSpaceField> fieldOf(const Scene& scene, const TipState& state,
                                              const HalfSpacePatch& patch,
                                              std::vector<double> displacement) {
    const ContactModel model = contactModelAt(scene, state);
    auto pixel = displacement.begin();
    patch.forEachDistance([&](double distance) {
        *pixel -= tailLift(model, state.contact, distance);
        ++pixel;
    });
    return std::make_shared<const HalfSpaceField>(displacement, patch.samples, patch.pitch());
}

/// Of bodies in contact, less the cohesive stress.
std::shared_ptr<const PixelField> pressureOf(const HalfSpaceContact& problem,
                                             const SurfaceTraction& traction) {
    HeightMap map{.columns = problem.samples,
                  .rows = problem.samples,
                  .pitchX = problem.pitch,
                  .pitchY = problem.pitch,
                  .heights = {},
                  .invalid = {}};
    for (int row = problem.samples - 1; row >= 0; --row) {  // an image's top row is the last one
        for (int column = 0; column < problem.samples; ++column) {
            const std::size_t pixel = map.index(row, column);
            map.heights.push_back(traction.contact[pixel] -
                                  problem.cohesiveStress * traction.cohesion[pixel]);
        }
    }
    return std::make_shared<const PixelField>(map, "Pa");
}

}  // namespace

bool stillHolds(const HalfSpaceAnswer& answer, const TipState& now) {
    constexpr double kSameWidth = 0.1;
    const ContactState& then = answer.state.contact;
    const double width = then.cohesiveRadius;
    return answer.valid() && now.contact.region() == then.region() &&
           std::abs(now.contact.cohesiveRadius - width) < kSameWidth * width &&
           (now.closest.point - answer.state.closest.point).norm() < width;
}

HalfSpaceModel::HalfSpaceModel(int samples, HalfSpaceLimits limits)
    : samples_(samples), solver_(limits) {}

/// The patch before, where it still suits: only on the same pixels is its pressure a start.
double HalfSpaceModel::halfWidthFor(const TipState& state, double tipRadius) const {
    const double radius = state.contact.cohesiveRadius;
    const double least = state.points > 1 ? kSeveralPointsRoom * tipRadius : 0.0;
    const double before = kept_ ? kept_->halfWidth : 0.0;
    const bool suits = before >= std::max(least, kMinRoom * radius) &&
                       before <= std::max(least, kMaxRoom * radius);
    return suits ? before : std::min(std::max(least, kRoom * radius), kMaxPatchWidth * tipRadius);
}

HalfSpaceAnswer HalfSpaceModel::solve(const Scene& scene, const TipState& state,
                                      const std::stop_token& stop) {
    HalfSpaceAnswer answer{.verdict = askable(scene, state), .state = state, .field = nullptr};
    if (!answer.valid()) {
        kept_.reset();
        return answer;
    }
    const double tipRadius = scene.belief.tipRadius();
    HalfSpacePatch patch{.samples = samples_, .halfWidth = halfWidthFor(state, tipRadius)};
    HalfSpaceContact problem;
    HalfSpaceSolution solution;
    for (;;) {
        const bool warm = kept_ && kept_->halfWidth == patch.halfWidth;
        problem = halfSpaceContact(scene, state, patch);
        solution = solver_.solve(
            problem, warm ? kept_->traction : closedFormTraction(scene, state, patch), stop);
        const bool wider =
            solution.doubts.reachesBorder && kWiden * patch.halfWidth <= kMaxPatchWidth * tipRadius;
        if (!wider || solution.status == HalfSpaceStatus::Canceled) {
            break;
        }
        patch.halfWidth *= kWiden;
    }
    answer.verdict = verdictOn(solution);
    answer.force = solution.force + forceBeyondZone(scene, state);
    answer.contactRadius = solution.contactRadius;
    answer.iterations = solution.iterations;
    kept_.reset();
    if (answer.valid()) {
        answer.field = fieldOf(scene, state, patch, std::move(solution.displacement));
        answer.pressure = pressureOf(problem, solution.traction);
        kept_ = Kept{.halfWidth = patch.halfWidth, .traction = std::move(solution.traction)};
    }
    return answer;
}

}  // namespace asperity
