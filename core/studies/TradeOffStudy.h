#pragma once

#include "core/Progress.h"
#include "core/scene/ForceModelOptions.h"
#include "core/scene/ModelTerm.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// Accuracy with which a picture shows the surface around the contact.
struct FrameOptions {
    DeformationModel deformation = DeformationModel::ClosedForm;
    int samples = 97;  ///< of the patch, a side
};

/// Returns the name for people: "closed form, 97 x 97".
[[nodiscard]] std::string nameOf(const FrameOptions& options);

/// The models that a tick of this scene can take: each law that its sample allows, with each solver
/// but the one afresh and each search for closest points, and all other terms; then the scene's own
/// model, and the same with all other terms but one.
[[nodiscard]] std::vector<ForceModelOptions> tickModels(const Scene& scene);

/// All options for its picture.
[[nodiscard]] std::vector<FrameOptions> frameOptions();

/// A choice: what it costs and how wrong it is, both the less the better.
struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

/// Below what choices cannot be told apart.
struct Resolution {
    double cost = 0.0;   ///< as a share
    double error = 0.0;  ///< errors below it count as that: nothing is known of them
};

/// Returns cost and error of each result.
template <class Result>
[[nodiscard]] std::vector<CostAndError> costsAndErrors(const std::vector<Result>& results) {
    std::vector<CostAndError> choices;
    for (const Result& result : results) {
        choices.push_back(result.costAndError());
    }
    return choices;
}

/// Returns for each choice whether it is on the front: cheaper than all on it that are as near or
/// nearer. The nearest of all begins it: the cheapest of those that cannot be told from it.
[[nodiscard]] std::vector<bool> paretoFront(std::span<const CostAndError> choices,
                                            const Resolution& resolution);

/// Has results say whether they are on the front.
template <class Result>
void markFront(std::vector<Result>& results, const Resolution& resolution) {
    const std::vector<bool> front = paretoFront(costsAndErrors(results), resolution);
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].onFront = front[i];
    }
}

/// Returns, of the choices whose error is at most `tolerance`, the nearest of those that cannot be
/// told from the cheapest. Their count where there is none.
[[nodiscard]] std::size_t cheapestWithin(std::span<const CostAndError> choices, double tolerance,
                                         const Resolution& resolution);

/// Cost of one model for the tick and its error against the reference on the same inputs.
struct TickResult {
    ForceModelOptions options;
    double median = 0.0;              ///< of one tick [s]
    double p99 = 0.0;                 ///< [s]
    double forceErrorRms = 0.0;       ///< of the model force's vector over the runs [N]
    double forceErrorMax = 0.0;       ///< [N]
    double contactRadiusError = 0.0;  ///< largest [m]
    double closestPointError = 0.0;   ///< largest, of the closest point while it bears a force [m]
    double estimateErrorRms = 0.0;    ///< of the force from the signals against the true one [N]
    bool onFront = false;             ///< Pareto-optimal, as far as resolved

    [[nodiscard]] CostAndError costAndError() const { return {median, forceErrorRms}; }
};

/// The same of one option for the picture.
struct FrameResult {
    FrameOptions options;
    double median = 0.0;           ///< of one patch [s]
    double surfaceErrorRms = 0.0;  ///< of the displacement along z, over the reference's patch [m]
    double surfaceErrorMax = 0.0;  ///< [m]
    bool onFront = false;

    [[nodiscard]] CostAndError costAndError() const { return {median, surfaceErrorRms}; }
};

/// Cost of a tick rate, and the error of a force that is held from tick to tick.
struct RateResult {
    double rate = 0.0;          ///< [Hz]
    double load = 0.0;          ///< share of one core
    double holdErrorRms = 0.0;  ///< of the held force against ticks without end [N]
};

/// A term that the reference's law has no room for, and what it moves the force by.
struct MissedTerm {
    ModelTerm term = ModelTerm::Adhesion;
    double force = 0.0;  ///< root mean square [N]
};

/// Source of the error of the reference's surface.
enum class SurfaceDoubt : std::uint8_t {
    ByCoarser,     ///< by a half-space of half as many pixels a side
    CoarserFails,  ///< not at all: that one does not hold
    NothingFiner,  ///< not at all: no half-space holds, and nothing finer is known
};

/// The reference, and how far it may be off itself, by a finer one.
struct TradeOffReference {
    ForceModelOptions tick;
    FrameOptions frame;
    double tickMedian = 0.0;         ///< [s]
    double forceScale = 0.0;         ///< root mean square of its force over the runs [N]
    double contactRatio = 0.0;       ///< largest contact radius over tip radius
    int contacts = 0;                ///< at which pictures are compared: those where it holds
    int contactsAsked = 0;           ///< of these
    double indentation = 0.0;        ///< root mean square over these contacts [m]
    double forceDoubt = 0.0;         ///< root mean square [N]
    double surfaceDoubt = 0.0;       ///< root mean square [m]
    std::vector<MissedTerm> missed;  ///< forceDoubt, by term
    SurfaceDoubt surfaceDoubtBy = SurfaceDoubt::NothingFiner;
    /// Difference of the normal force from the half-space's own, at the contacts where that holds,
    /// root mean square [N].
    double halfSpaceForce = 0.0;
};

struct TradeOff {
    TradeOffReference reference;
    std::vector<TickResult> ticks;
    std::vector<TickResult> decouplings;  ///< of the scene's own model
    std::vector<FrameResult> frames;
    std::vector<RateResult> rates;
    double timeResolution = 0.0;  ///< shares by which times differ without meaning it

    /// Returns the smallest differences that count, of ticks and of pictures.
    [[nodiscard]] Resolution ofTicks() const { return {timeResolution, reference.forceDoubt}; }
    [[nodiscard]] Resolution ofFrames() const { return {timeResolution, reference.surfaceDoubt}; }
};

/// Number and length of the measurements.
struct TradeOffPlan {
    double duration = 2.0;  ///< of each of two runs: approach at the highest feature, raster at
                            ///< another position [s]
    int rounds = 5;         ///< timed runs of each option, options taking turns
    int patches = 6;        ///< moments of the run at which surfaces are compared
};

/// Runs the scene with every option. Accuracy is taken on the virtual clock and is reproducible;
/// times are of this machine, the options interleaved so that they share its mood. Of the
/// references see TickStudy and studySurfaces().
/// @param scene    has its model changed; it is left as it was, also by a throw
/// @param progress may be null  @throw Canceled
[[nodiscard]] TradeOff studyTradeOff(Scene& scene, const TradeOffPlan& plan,
                                     Progress* progress = nullptr);

}  // namespace asperity
