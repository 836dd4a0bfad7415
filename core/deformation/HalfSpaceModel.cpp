#include "core/deformation/HalfSpaceModel.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/SplitLaw.h"
#include "core/scene/Scene.h"
#include "core/surface/HeightMap.h"
#include "core/surface/PixelField.h"
#include "core/surface/TangentFrame.h"
#include "core/surface/fit/BSplineFit.h"

#include <algorithm>
#include <exception>
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

/// Returns whether the law's adhesion has no range that a half-space could take for its own: JKR's
/// has none, DMT's reaches everywhere.
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

/// Pressure of bodies in contact, less the cohesive stress.
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

constexpr double kNoTip = 1e-3;  // gap beyond a sphere's equator [m]: no surface reaches so far

/// The cohesive zone of a law; none where the law has none.
struct Cohesion {
    double stress = 0.0;  ///< [Pa]
    double range = 0.0;   ///< [m]
};

Cohesion cohesionOf(const ContactModel& model) {
    const double stress = model.cohesiveStress();
    return stress > 0.0 ? Cohesion{stress, model.cohesiveRange()} : Cohesion{};
}

bool isSame(const TipState& first, const TipState& second) {
    return first.tip == second.tip && first.contact.indentation == second.contact.indentation &&
           first.contact.branch == second.contact.branch;
}

/// A thread may not throw: what cannot be solved counts as not converged.
HalfSpaceAnswer answerTo(HalfSpaceModel& model, const Scene& scene, const TipState& state,
                         const std::stop_token& stop) {
    try {
        return model.solve(scene, state, stop);
    } catch (const std::exception&) {
        return {.verdict = HalfSpaceVerdict::NotConverged, .state = state, .field = nullptr};
    }
}

/// The grid as an image: its top row is the last one.
HeightMap imageOf(const std::vector<double>& displacement, int samples, double pitch) {
    HeightMap map{.columns = samples,
                  .rows = samples,
                  .pitchX = pitch,
                  .pitchY = pitch,
                  .heights = {},
                  .invalid = {}};
    map.heights.reserve(displacement.size());
    for (int row = samples - 1; row >= 0; --row) {
        const auto first = displacement.begin() + static_cast<std::ptrdiff_t>(row) * samples;
        map.heights.insert(map.heights.end(), first, first + samples);
    }
    return map;
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

HalfSpaceContact halfSpaceContact(const Scene& scene, const TipState& state,
                                  const HalfSpacePatch& patch) {
    const ContactModel model = contactModelAt(scene, state);
    const Cohesion cohesion = cohesionOf(model);
    const double radius = scene.belief.tipRadius();
    HalfSpaceContact contact{
        .samples = patch.samples,
        .pitch = patch.pitch(),
        .gap = heightsOver(scene.surface, tangentFrame(state.closest.point, state.closest.normal),
                           patch.samples, patch.pitch()),
        .approach = contactProfile(model, state.contact).indentation,
        .reducedModulus = model.pair().reducedModulus,
        .cohesiveStress = cohesion.stress,
        .cohesiveRange = cohesion.range,
        .tipRadius = std::min(radius, model.pair().tipRadius)};
    const RoundTip tip = scene.description.tip.shape();
    auto height = contact.gap.begin();
    patch.forEachDistance([&](double distance) {
        const double above = distance < tip.reach() ? tip.height(distance) : kNoTip;
        *height = std::min(above - *height, kNoTip);
        ++height;
    });
    return contact;
}

SurfaceTraction closedFormTraction(const Scene& scene, const TipState& state,
                                   const HalfSpacePatch& patch) {
    const ContactModel model = contactModelAt(scene, state);
    const CohesiveContact profile = contactProfile(model, state.contact);
    const double stress = cohesionOf(model).stress;
    SurfaceTraction traction;
    patch.forEachDistance([&](double distance) {
        const bool touches = distance < profile.contactRadius;
        const double pressure = touches ? contactPressure(profile, distance) : 0.0;
        traction.contact.push_back(touches ? std::max(0.0, pressure + stress) : 0.0);
        traction.cohesion.push_back(stress > 0.0 && distance < profile.cohesiveRadius ? 1.0 : 0.0);
    });
    return traction;
}

double forceBeyondZone(const Scene& scene, const TipState& state) {
    const ContactModel model = contactModelAt(scene, state);
    const AdhesionSplit* shares = model.split();
    const double tail = shares != nullptr ? shares->tailForce : 0.0;
    return tail - scene.description.meniscus.pull(model.pair().tipRadius);
}

HalfSpaceWorker::HalfSpaceWorker(const Scene& scene)
    : scene_(scene), thread_([this](const std::stop_token& stop) { work(stop); }) {}

HalfSpaceWorker::~HalfSpaceWorker() = default;

void HalfSpaceWorker::ask(const TipState& state) {
    if (isSame(state, asked_)) {
        return;
    }
    asked_ = state;
    {
        const std::lock_guard lock(mutex_);
        next_ = state;
    }
    waiting_.notify_one();
}

std::shared_ptr<const HalfSpaceAnswer> HalfSpaceWorker::newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
}

void HalfSpaceWorker::work(const std::stop_token& stop) {
    HalfSpaceModel model;
    while (true) {
        std::unique_lock lock(mutex_);
        if (!waiting_.wait(lock, stop, [this] { return next_.has_value(); })) {
            return;
        }
        const TipState state = *std::exchange(next_, std::nullopt);
        lock.unlock();
        auto answer = std::make_shared<const HalfSpaceAnswer>(answerTo(model, scene_, state, stop));
        lock.lock();
        newest_ = std::move(answer);
    }
}

HalfSpaceField::HalfSpaceField(const std::vector<double>& displacement, int samples, double pitch)
    : halfWidth_(0.5 * (samples - 1) * pitch)
    , middle_(0.5 * samples * pitch)
    , displacement_(fitSurface(imageOf(displacement, samples, pitch))) {}

double HalfSpaceField::at(double along, double across) const {
    const double reach = std::max(std::abs(along), std::abs(across));
    const double inside = reach > halfWidth_ ? halfWidth_ / reach : 1.0;
    return inside * displacement_.at(middle_ + inside * along, middle_ + inside * across).height;
}

DisplacementField halfSpaceField(const TipContact& contact,
                                 std::shared_ptr<const HalfSpaceField> field, double share) {
    return [frame = tangentFrame(contact.closest, contact.normal), field = std::move(field),
            share](const Vector3& rest) -> Vector3 {
        const Vector3 position = frame.local(rest);
        return -share * field->at(position.x(), position.y()) * frame.normal;
    };
}

}  // namespace asperity
