#include "core/studies/TickStudy.h"

#include "core/contact/laws/ContactModel.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kP99 = 0.99;

double largestContactRatio(const ModelRun& run) {
    return largestOf(run, [](const TipState& state) { return state.contactRatio; });
}

bool isCurved(const ModelRun& run) {
    return std::ranges::any_of(run.states, [](const TipState& state) {
        return state.contact.contactRadius > 0.0 && state.anisotropic;
    });
}

double estimateError(const ModelRun& run, const std::vector<ModelInputs>& runs) {
    double sum = 0.0;
    std::size_t at = 0;
    for (const ModelInputs& recorded : runs) {
        for (const Vector3& force : recorded.trueForces) {
            sum += (run.estimates[at++] - force).squaredNorm();
        }
    }
    return std::sqrt(sum / static_cast<double>(at));
}

/// Half of what the medians of a model's rounds differ by, as a share of the smallest.
double spreadOf(const std::vector<double>& medians) {
    const auto [least, most] = std::ranges::minmax(medians);
    return least > 0.0 ? 0.5 * (most - least) / least : 0.0;
}

constexpr double kFrameRate = 60.0;     // [Hz]
constexpr double kHapticRate = 1000.0;  // that a device needs to feel a stiff contact [Hz]

double share(double error, double scale) { return scale > 0.0 ? error / scale : 0.0; }

std::vector<Composition> compositions(const TradeOff& study) {
    const TradeOffReference& reference = study.reference;
    std::vector<Composition> all;
    for (std::size_t t = 0; t < study.ticks.size(); ++t) {
        for (std::size_t r = 0; r < study.rates.size(); ++r) {
            if (study.rates[r].rate < kHapticRate) {
                continue;
            }
            const double force =
                std::hypot(study.ticks[t].forceErrorRms, study.rates[r].holdErrorRms);
            for (std::size_t f = 0; f < study.frames.size(); ++f) {
                const FrameResult& frame = study.frames[f];
                all.push_back(
                    {.tick = t,
                     .rate = r,
                     .frame = f,
                     .load =
                         study.rates[r].rate * study.ticks[t].median + kFrameRate * frame.median,
                     .error = std::max(share(force, reference.forceScale),
                                       share(frame.surfaceErrorRms, reference.indentation))});
            }
        }
    }
    return all;
}

Resolution resolutionOf(const TradeOff& study) {
    const TradeOffReference& reference = study.reference;
    return {.cost = study.timeResolution,
            .error = std::max(share(reference.forceDoubt, reference.forceScale),
                              share(reference.surfaceDoubt, reference.indentation))};
}

}  // namespace

TickStudy::TickStudy(Scene& scene, const TradeOffPlan& plan, Progress* progress)
    : scene_(scene), plan_(plan), progress_(progress), model_(wholeModel(scene)) {
    const Vector2 other(0.31 * scene.surface.sizeX(), 0.62 * scene.surface.sizeY());
    for (const DevicePath& path :
         {slidePath(scene, {.duration = plan.duration}),
          rasterPath(scene, {.duration = plan.duration, .position = other})}) {
        runs_.push_back(recordInputs(scene, path, plan.duration, progress));
    }
    chooseReference();
}

void TickStudy::chooseReference() {
    const bool adhesive = isPossible(ModelTerm::Adhesion, scene_.description);
    if (adhesive && isPossible(ModelTerm::FilmBase, scene_.description) &&
        missedBy(ModelTerm::FilmBase) > missedBy(ModelTerm::Adhesion)) {
        model_ = with(model_, ModelTerm::FilmBase);
    }
    reference_ = run(model_);
    const ForceModelOptions sphere = with(model_, ModelTerm::SphereCorrection);
    if (!has(model_, ModelTerm::FilmBase) && isLargeContact(largestContactRatio(reference_), 1.0)) {
        // That law takes the sample as flat: nothing to hold on to where it is not.
        if (ModelRun exact = run(sphere); !isCurved(exact)) {
            model_ = sphere;
            reference_ = std::move(exact);
        }
    }
}

std::vector<TickResult> TickStudy::measured(const std::vector<ForceModelOptions>& models) {
    std::vector<TickResult> results;
    std::vector<std::vector<double>> times(models.size());
    std::vector<std::vector<double>> medians(models.size());
    for (int round = 0; round < plan_.rounds; ++round) {
        for (std::size_t i = 0; i < models.size(); ++i) {
            const ModelRun timed = run(models[i]);
            times[i].insert(times[i].end(), timed.times.begin(), timed.times.end());
            medians[i].push_back(quantile(timed.times, 0.5));
            const auto done =
                static_cast<double>(static_cast<std::size_t>(round) * models.size() + i);
            reportTo(progress_, done / static_cast<double>(models.size() * (plan_.rounds + 1)));
        }
    }
    for (std::size_t i = 0; i < models.size(); ++i) {
        results.push_back(resultOf(models[i]));
        results[i].median = quantile(times[i], 0.5);
        results[i].p99 = quantile(times[i], kP99);
        spreads_.push_back(spreadOf(medians[i]));
    }
    reportTo(progress_, 1.0);
    return results;
}

double TickStudy::timeResolution() const {
    constexpr double kFromRunToRun = 0.05;
    return std::max(quantile(spreads_, 0.5), kFromRunToRun);
}

double TickStudy::missedBy(ModelTerm term) {
    const TermPair models = pairOf(term, model_);
    const ModelRun in = run(models.with);
    return differenceOf(run(models.without), in).rms;
}

void TickStudy::describe(TradeOffReference& reference) {
    reference.tick = ofForce(model_);
    reference.tickMedian = quantile(reference_.times, 0.5);
    reference.forceScale = forceScale(reference_);
    reference.contactRatio = largestContactRatio(reference_);
    double sum = 0.0;
    for (const ModelTerm term : missingTerms(model_, scene_)) {
        reference.missed.push_back({.term = term, .force = missedBy(term)});
        sum += reference.missed.back().force * reference.missed.back().force;
    }
    reference.forceDoubt = std::sqrt(sum);
}

ModelRun TickStudy::run(const ForceModelOptions& model) {
    setModel(scene_, model);
    return runModel(scene_, runs_, progress_);
}

TickResult TickStudy::resultOf(const ForceModelOptions& options) {
    const ModelRun done = run(options);
    const ForceDifference difference = differenceOf(done, reference_);
    return {.options = options,
            .forceErrorRms = difference.rms,
            .forceErrorMax = difference.largest,
            .contactRadiusError = difference.contactRadius,
            .closestPointError = difference.closest,
            .estimateErrorRms = estimateError(done, runs_)};
}

std::vector<Composition> bestCompositions(const TradeOff& study) {
    const std::vector<Composition> all = compositions(study);
    const std::vector<bool> front = paretoFront(costsAndErrors(all), resolutionOf(study));
    std::vector<Composition> best;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (front[i]) {
            best.push_back(all[i]);
        }
    }
    std::ranges::sort(best, {}, &Composition::load);
    return best;
}

std::optional<Composition> cheapestComposition(const TradeOff& study, double tolerance) {
    const std::vector<Composition> all = compositions(study);
    const std::size_t best = cheapestWithin(costsAndErrors(all), tolerance, resolutionOf(study));
    return best < all.size() ? std::optional(all[best]) : std::nullopt;
}

}  // namespace asperity
