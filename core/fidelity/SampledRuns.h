#pragma once

#include "core/Vector.h"
#include "core/fidelity/ModelRun.h"
#include "core/scene/ForceModelOptions.h"
#include "core/scene/JudgedQuantity.h"

#include <cmath>
#include <list>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

struct Scene;

/// Squares of the difference of two forces along a run or a curve, and of the reference itself, in
/// any unit.
struct ForceSquares {
    double heldAlike = 0.0;  ///< of the difference where both hold the tip, or both do not
    double heldByOne = 0.0;  ///< where one has jumped and the other has not
    double reference = 0.0;

    /// The error of the rms force as a share: the root mean square of the difference over that of
    /// the reference, and of a jump that comes earlier or later the share of the mean square that
    /// lies between the two. That is as small as the jump's displacement. The root of it is not: it
    /// would make 10 % of the force of a displacement that nobody sees, 1 % of the curve.
    /// 0 where there is no force.
    [[nodiscard]] double share() const noexcept {
        return reference > 0.0 ? std::sqrt(heldAlike / reference) + (heldByOne / reference) : 0.0;
    }
};

/// The force along z over the height of the base, piece by piece a straight line; 0 outside it.
class ForceLine {
public:
    struct Point {
        double base = 0.0;   ///< [m]
        double force = 0.0;  ///< along z [N]
    };

    /// @param points in rising order; a jump is two points at one height
    explicit ForceLine(std::vector<Point> points) : points_(std::move(points)) {}

    [[nodiscard]] double at(double base) const noexcept;  ///< [N]
    [[nodiscard]] const std::vector<Point>& points() const noexcept { return points_; }

private:
    std::vector<Point> points_;
};

/// Results of a model for an approach until the force along z is the setpoint, and for the retract
/// until the tip is free, see JudgedQuantity. Forces along z, pulls > 0.
struct SampledCycle {
    double pullOffForce = 0.0;    ///< [N]
    double pullOffBase = 0.0;     ///< height of the base where the tip pulls off [m]
    double snapInForce = 0.0;     ///< [N]
    double snapInBase = 0.0;      ///< same [m]
    double setpointBase = 0.0;    ///< and at the setpoint [m]
    double indentation = 0.0;     ///< at the setpoint [m]
    double pulled = 0.0;          ///< by how much the indentation falls until the pull-off [m]
    double stiffness = 0.0;       ///< at the setpoint [N/m]
    double separationWork = 0.0;  ///< [J]
    double setpoint = 0.0;        ///< [N]
    ForceLine approach;
    ForceLine retract;
};

/// Runs a cycle of the scene's model. None: the tip does not engage there, or stays bonded.
/// @param base world x, y [m] @param setpoint [N]
[[nodiscard]] std::optional<SampledCycle> sampleCycle(const Scene& scene, const Vector2& base,
                                                      double setpoint);

/// The errors of one model's cycle against that of another at the same position.
[[nodiscard]] QuantityErrors errorsOf(const SampledCycle& cycle, const SampledCycle& reference);

struct Scene;

/// Results of a model for the sampled runs and cycles of a scene.
struct ModelSample {
    ForceModelOptions model;  ///< as ofForce() has it
    ModelRun run;             ///< all runs in a row
    double tickTime = 0.0;    ///< median of a tick in them; of this machine [s]
    std::vector<std::optional<SampledCycle>> cycles;  ///< a position each, see sampleCycle()
};

/// Runs and cycles over a scene on which its models are compared. Runs: approach, slide and retract
/// at the highest feature and, half and a quarter as deep, at two more positions, and lines to and
/// fro around the first; the inputs are those of the scene's usual model. Cycles to the scene's
/// setpoint: at sampledPositions().
class SampledRuns {
public:
    /// @param scene       must outlive this; its model is changed and left changed
    /// @param longestTick of which somebody would wait for more runs [s]
    /// @param progress    may be null, must outlive this; asked at every tick and cycle whether the
    ///                    work is canceled. @throw Canceled, as all that runs a model
    SampledRuns(Scene& scene, double longestTick, const Progress* progress = nullptr);

    /// Returns whether ticks take longer than that here; then there is one run, of the usual model.
    [[nodiscard]] bool isSlow() const noexcept { return slow_; }
    /// Median of a tick of the usual model in the first run [s].
    [[nodiscard]] double usualTickTime() const noexcept { return usualTickTime_; }

    /// Returns the results of a model for them, computed once for each model. Sets the scene's
    /// model. The reference stays valid as long as this lives.
    [[nodiscard]] const ModelSample& of(const ForceModelOptions& model);

    /// The error of each quantity, the worst of all runs and cycles. Sets the scene's model.
    [[nodiscard]] QuantityErrors errors(const ForceModelOptions& model,
                                        const ForceModelOptions& reference);

    /// Returns by how much the median tick of one model takes longer than that of another one in
    /// the first run [s]. One comes right after the other: others work on the machine, too. Sets
    /// the scene's model.
    [[nodiscard]] double timeDifference(const ForceModelOptions& one,
                                        const ForceModelOptions& other);

private:
    void addRun(const DevicePath& path);

    Scene& scene_;
    const Progress* progress_;
    std::vector<ModelInputs> runs_;
    std::vector<Vector2> positions_;
    std::list<ModelSample> samples_;
    double usualTickTime_ = 0.0;
    bool slow_ = false;
};

/// The error of the force of a run against that of another, see ForceSquares. A tick in which one
/// of them holds the tip and the other does not does not count where those beside it agree: there a
/// jump comes by a fraction of a tick earlier, and only a cycle says by which, see SampledCycle.
[[nodiscard]] double forceShare(std::span<const TipState> run, std::span<const TipState> reference);

/// Positions of the base, world x and y [m], at which models of a scene are compared: the highest
/// feature; the positions where the tip touches the sample with the smallest, the largest and the
/// quartiles of effective radius; with the steepest slopes along x and along y, both ways; of a
/// sample of several materials the softest, the stiffest, the least and the most adhesive. Where
/// the tip does not fit, also above the sharpest hollow. Positions that look alike count once; a
/// part of the sample that the tip cannot reach does not count, nor one outside the scan or without
/// data. The same for every model of the scene.
[[nodiscard]] std::vector<Vector2> sampledPositions(const Scene& scene);

}  // namespace asperity
