#pragma once

#include "core/Progress.h"
#include "core/scene/ModelTerm.h"
#include "core/studies/Pareto.h"
#include "core/studies/TradeOffModels.h"

#include <cstdint>
#include <vector>

namespace asperity {

struct Scene;

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

/// What a tick rate costs, and what the force misses that is held from tick to tick.
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

/// How it is known how far the reference's surface may be off.
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
    int contactsAsked = 0;           ///< of so many
    double indentation = 0.0;        ///< root mean square over these contacts [m]
    double forceDoubt = 0.0;         ///< root mean square [N]
    double surfaceDoubt = 0.0;       ///< root mean square [m]
    std::vector<MissedTerm> missed;  ///< forceDoubt, by term
    SurfaceDoubt surfaceDoubtBy = SurfaceDoubt::NothingFiner;
    /// Of the normal force against the half-space's own, at the contacts where that holds, root
    /// mean square [N].
    double halfSpaceForce = 0.0;
};

struct TradeOff {
    TradeOffReference reference;
    std::vector<TickResult> ticks;
    std::vector<TickResult> decouplings;  ///< of the scene's own model
    std::vector<FrameResult> frames;
    std::vector<RateResult> rates;
    double timeResolution = 0.0;  ///< shares by which times differ without meaning it

    /// What cannot be told apart, of ticks and of pictures.
    [[nodiscard]] Resolution ofTicks() const { return {timeResolution, reference.forceDoubt}; }
    [[nodiscard]] Resolution ofFrames() const { return {timeResolution, reference.surfaceDoubt}; }
};

/// How much is measured.
struct TradeOffPlan {
    double duration =
        2.0;  ///< of each of two runs: approach at the highest feature, raster at another place [s]
    int rounds = 5;   ///< timed runs of each option, options taking turns
    int patches = 6;  ///< moments of the run at which surfaces are compared
};

/// Runs the scene with every option. Accuracy is taken on the virtual clock and is reproducible;
/// times are of this machine, the options interleaved so that they share its mood. Of the
/// references see TickStudy and studySurfaces().
/// @param scene    has its model changed meanwhile; it is left as it was, also by a throw
/// @param progress may be null  @throw Canceled
[[nodiscard]] TradeOff studyTradeOff(Scene& scene, const TradeOffPlan& plan,
                                     Progress* progress = nullptr);

}  // namespace asperity
