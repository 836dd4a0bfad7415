#include "core/fidelity/SampledRuns.h"

#include "core/contact/ContactState.h"
#include "core/haptics/DevicePath.h"
#include "core/map/JumpSearch.h"
#include "core/map/RetractCurve.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/ContactHeight.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

/// Error by rounding of a search for the setpoint, see findForce(), and of its tip.
constexpr double kRounding = 1e-9;

/// The difference as a share of `scale`, which is that of the reference.
double shareOf(double value, double reference, double scale, double rounding) {
    const double difference = std::abs(value - reference);
    if (!(difference > rounding)) {
        return std::isfinite(difference) ? 0.0 : 1.0;
    }
    return scale > rounding ? difference / scale : 1.0;
}

/// Error of a quantity as a share of it; where the reference has none, all of it is wrong.
double shareOf(double value, double reference, double rounding) {
    return shareOf(value, reference, std::abs(reference), rounding);
}

ForceLine::Point linePointOf(const VerticalPath& path, const RetractPoint& point) {
    return {.base = point.height - (path.complianceZ() * point.force), .force = point.force};
}

struct LineJump {
    double base = 0.0;    ///< [m]
    double bonded = 0.0;  ///< force below it [N]
    double free = 0.0;    ///< and above it [N]
};

/// The bonded points below a jump, the jump, and the free points above it.
ForceLine lineOf(std::vector<ForceLine::Point> bonded, const LineJump& jump,
                 const std::vector<ForceLine::Point>& free) {
    std::vector<ForceLine::Point> points = std::move(bonded);
    std::erase_if(points, [&](const ForceLine::Point& point) { return point.base >= jump.base; });
    // Near to the pull-off its search goes back and forth by some picometers.
    std::ranges::stable_sort(points, {}, &ForceLine::Point::base);
    points.push_back({jump.base, jump.bonded});
    points.push_back({jump.base, jump.free});
    for (const ForceLine::Point& point : free) {
        if (point.base > points.back().base) {
            points.push_back(point);
        }
    }
    return ForceLine(std::move(points));
}

std::vector<ForceLine::Point> linePointsOf(const VerticalPath& path,
                                           const std::vector<RetractPoint>& points) {
    std::vector<ForceLine::Point> line;
    std::ranges::transform(points, std::back_inserter(line),
                           [&](const RetractPoint& point) { return linePointOf(path, point); });
    return line;
}

/// Down from the snap-in to the setpoint: friction acts the other way than on the retract.
std::vector<ForceLine::Point> pressedWay(VerticalPath& path, const Engagement& engaged) {
    constexpr int kSteps = 16;
    const TipAtHeight& first = engaged.snapIn.after;
    std::vector<ForceLine::Point> points;
    EquilibriumMemory memory = first.memory;
    path.goDown();
    for (int i = 1; i < kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const TipAtHeight tip =
            path.at(std::lerp(first.base, engaged.atSetpoint.base, share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
    points.push_back({engaged.atSetpoint.base, engaged.atSetpoint.force()});
    return points;
}

/// The free tip from its snap-in up to the pull-off, where the retract goes on. Near the snap-in
/// the attraction changes most: steps are shorter there.
std::vector<ForceLine::Point> freeWay(VerticalPath& path, const FoundJump& snapIn,
                                      const RetractCurve& curve) {
    constexpr int kSteps = 8;
    const double top = curve.pullOff.base;
    std::vector<ForceLine::Point> points;
    EquilibriumMemory memory = snapIn.before.memory;
    path.goDown();
    for (int i = 1; i <= kSteps && top > snapIn.base; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const TipAtHeight tip = path.at(std::lerp(snapIn.base, top, share * share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
    std::ranges::move(linePointsOf(path, curve.free), std::back_inserter(points));
    return points;
}

ForceLine approachLine(VerticalPath& path, const Engagement& engaged, const RetractCurve& curve) {
    const FoundJump& jump = engaged.snapIn;
    return lineOf(pressedWay(path, engaged), {jump.base, jump.forceAfter(), jump.forceBefore()},
                  freeWay(path, jump, curve));
}

ForceLine retractLine(const VerticalPath& path, const RetractCurve& curve) {
    const FoundJump& jump = curve.pullOff;
    return lineOf(linePointsOf(path, curve.bonded),
                  {jump.base, jump.forceBefore(), jump.forceAfter()},
                  linePointsOf(path, curve.free));
}

/// By how much the indentation falls from a state until the tip pulls off [m].
double pulledFrom(const ContactState& contact, const FoundJump& pullOff) {
    return contact.indentation - (pullOff.exact ? pullOff.exact->before.indentation
                                                : pullOff.before.state.contact.indentation);
}

/// Integral of the square of what a function has between two heights, exact for straight lines.
template <class Function>
double squareBetween(double low, double high, const Function& function) {
    const double middle = std::midpoint(low, high);
    const double half = 0.5 * (high - low) / std::sqrt(3.0);  // Gauss, two points
    const double below = function(middle - half);
    const double above = function(middle + half);
    return 0.5 * (high - low) * (below * below + above * above);
}

/// Adds the squares of a difference over one way from a height of the base up, and of the
/// reference.
/// @param jump, jumpOfReference where the tip changes between free and bonded
void addSquares(const ForceLine& line, double jump, const ForceLine& reference,
                double jumpOfReference, double from, ForceSquares& squares) {
    const auto [first, last] = std::minmax(jump, jumpOfReference);
    std::vector<double> heights;
    for (const ForceLine* const each : {&line, &reference}) {
        for (const ForceLine::Point& point : each->points()) {
            heights.push_back(std::max(point.base, from));
        }
    }
    std::ranges::sort(heights);
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const double low = heights[i - 1];
        const double high = heights[i];
        const bool isBetween = low >= first && high <= last;
        (isBetween ? squares.heldByOne : squares.heldAlike) += squareBetween(
            low, high, [&](double base) { return line.at(base) - reference.at(base); });
        squares.reference +=
            squareBetween(low, high, [&](double base) { return reference.at(base); });
    }
}

/// Error of the force over both ways, from where both models have reached the setpoint.
double rmsShare(const SampledCycle& cycle, const SampledCycle& reference) {
    const double from = std::max(cycle.setpointBase, reference.setpointBase);
    ForceSquares squares;
    addSquares(cycle.approach, cycle.snapInBase, reference.approach, reference.snapInBase, from,
               squares);
    addSquares(cycle.retract, cycle.pullOffBase, reference.retract, reference.pullOffBase, from,
               squares);
    return squares.share();
}

constexpr int kTicksAPath = 120;

/// Returns whether the same contact points bear a force.
bool isHeldAlike(const TipState& a, const TipState& b) {
    return (a.contact.contactRadius > 0.0) == (b.contact.contactRadius > 0.0) &&
           a.points == b.points;
}

QuantityErrors cycleErrors(const std::optional<SampledCycle>& cycle,
                           const SampledCycle& reference) {
    if (cycle) {
        return errorsOf(*cycle, reference);
    }
    QuantityErrors nothing;  // to be read, where there is something
    for (const JudgedQuantity quantity : kValues<JudgedQuantity>) {
        nothing[quantity] = 1.0;
    }
    return nothing;
}

/// Pixels along an axis that are looked at: a scan of usual size is looked at in full.
constexpr int kMaxAcross = 256;
/// Share of the scan's side: nearer to its edge a run has no room.
constexpr double kEdge = 0.02;
/// Positions whose features differ by less look alike: an error of 1 % is known to half of itself
/// by a position whose radius, and with it the pull-off, differs by as much.
constexpr double kAlike = 0.005;

/// Features by which contacts at different positions differ.
enum Feature : std::size_t { Radius, SlopeX, SlopeY, Modulus, Adhesion, FeatureCount };

/// A point of the sample with the position of the base at which the tip touches it.
struct ContactSite {
    Vector2 base;         ///< world [m]
    double center = 0.0;  ///< height of the tip's center [m]
    std::array<double, FeatureCount> features{};
};

bool lookAlike(const ContactSite& a, const ContactSite& b) {
    const auto ratioDiffers = [&](Feature feature) {
        return std::abs(a.features[feature] - b.features[feature]) >
               kAlike * std::max(std::abs(a.features[feature]), std::abs(b.features[feature]));
    };
    const auto slopeDiffers = [&](Feature feature) {
        return std::abs(a.features[feature] - b.features[feature]) > kAlike;
    };
    return !ratioDiffers(Radius) && !ratioDiffers(Modulus) && !ratioDiffers(Adhesion) &&
           !slopeDiffers(SlopeX) && !slopeDiffers(SlopeY);
}

/// All contact sites of the tip, and the sharpest hollow that it does not fit.
class ContactSites {
public:
    explicit ContactSites(const Scene& scene) : scene_(scene), radius_(scene.belief.tipRadius()) {
        const BSplineSurface::Grid& grid = scene.surface.grid();
        const int stepX = 1 + (grid.columns - 1) / kMaxAcross;
        const int stepY = 1 + (grid.rows - 1) / kMaxAcross;
        for (int row = stepY / 2; row < grid.rows; row += stepY) {
            for (int column = stepX / 2; column < grid.columns; column += stepX) {
                look((column + 0.5) * grid.pitchX, (row + 0.5) * grid.pitchY);
            }
        }
    }

    [[nodiscard]] const std::vector<ContactSite>& all() const noexcept { return all_; }
    [[nodiscard]] const std::optional<Vector2>& hollow() const noexcept { return hollow_; }

    /// The point of the sample below a position [m].
    [[nodiscard]] ContactSite at(const Vector2& position, const HeightSample& sample,
                                 double effectiveRadius) const {
        const Vector3 toCenter = radius_ * sample.normal();
        const LocalMaterial material = materialAt(position);
        return {.base = position + toCenter.head<2>(),
                .center = sample.height + toCenter.z(),
                .features = {effectiveRadius, sample.dx, sample.dy, material.youngsModulus,
                             material.workOfAdhesion}};
    }

    /// Returns whether no other part of the sample keeps the tip from there.
    [[nodiscard]] bool isReached(const ContactSite& site) const {
        constexpr double kOfRadius = 1e-3;
        return tipContactHeight(scene_.surface, site.base.x(), site.base.y(), radius_) -
                   site.center <
               kOfRadius * radius_;
    }

private:
    void look(double x, double y) {
        const HeightSample sample = scene_.surface.at(x, y);
        const PrincipalCurvatures bend = principalCurvatures(sample);
        const EffectiveRadius effective = effectiveRadius(radius_, bend.largest, bend.smallest);
        const Vector2 position(x, y);
        if (!effective.tipFits && isInside(position) && bend.smallest < sharpest_) {
            sharpest_ = bend.smallest;
            hollow_ = position;
        }
        const ContactSite site = at(position, sample, effective.radius);
        if (effective.tipFits && isInside(site.base)) {
            all_.push_back(site);
        }
    }

    [[nodiscard]] bool isInside(const Vector2& position) const {
        const auto isBetween = [](double coordinate, double size) {
            return coordinate >= kEdge * size && coordinate <= (1.0 - kEdge) * size;
        };
        return isBetween(position.x(), scene_.surface.sizeX()) &&
               isBetween(position.y(), scene_.surface.sizeY()) &&
               scene_.surface.isMeasured(position.x(), position.y());
    }

    [[nodiscard]] LocalMaterial materialAt(const Vector2& position) const {
        return scene_.belief.field ? scene_.belief.field->at(position.x(), position.y())
                                   : LocalMaterial{};
    }

    const Scene& scene_;
    double radius_;  ///< of the tip [m]
    std::vector<ContactSite> all_;
    std::optional<Vector2> hollow_;  ///< world [m]
    double sharpest_ = 0.0;          ///< curvature there [1/m]
};

/// The positions chosen so far, without two that look alike.
class Chosen {
public:
    explicit Chosen(const ContactSites& sites) : sites_(sites) {}

    /// Takes, of all sites in the order of a feature, those with these shares of the others
    /// before them; where the tip does not reach one, the next one towards the middle that it does.
    void takeSpread(Feature feature, std::span<const double> shares) {
        std::vector<const ContactSite*> order;
        for (const ContactSite& site : sites_.all()) {
            order.push_back(&site);
        }
        std::ranges::stable_sort(
            order, {}, [feature](const ContactSite* site) { return site->features.at(feature); });
        for (const double share : shares) {
            takeReached(order, share);
        }
    }

    void take(const ContactSite& site) {
        if (std::ranges::none_of(taken_, [&](const auto& t) { return lookAlike(t, site); })) {
            taken_.push_back(site);
        }
    }

    [[nodiscard]] std::vector<Vector2> positions() const {
        std::vector<Vector2> positions;
        for (const ContactSite& site : taken_) {
            positions.push_back(site.base);
        }
        return positions;
    }

private:
    /// On a rough sample most of the extremes are out of reach: steps grow.
    void takeReached(const std::vector<const ContactSite*>& order, double share) {
        constexpr int kTries = 32;
        for (int i = 0; i < kTries; ++i) {
            const double now = share + ((0.5 - share) * i * i / (kTries * kTries));
            const double rank = now * static_cast<double>(order.size() - 1);
            const ContactSite& found = *order[static_cast<std::size_t>(std::lround(rank))];
            if (sites_.isReached(found)) {
                take(found);
                return;
            }
        }
    }

    const ContactSites& sites_;
    std::vector<ContactSite> taken_;
};

void takeSpread(const Scene& scene, Chosen& chosen) {
    constexpr std::array kOrder{0.0, 1.0, 0.5, 0.25, 0.75};  // extremes first: they stay
    constexpr std::array kExtremes{0.0, 1.0};
    chosen.takeSpread(Radius, kOrder);
    chosen.takeSpread(SlopeX, kExtremes);
    chosen.takeSpread(SlopeY, kExtremes);
    if (scene.belief.field) {
        chosen.takeSpread(Modulus, kExtremes);
        chosen.takeSpread(Adhesion, kExtremes);
    }
}

}  // namespace

double ForceLine::at(double base) const noexcept {
    const auto above = std::ranges::upper_bound(points_, base, {}, &Point::base);
    if (above == points_.begin() || above == points_.end()) {
        return 0.0;
    }
    const Point& below = *std::prev(above);
    return std::lerp(below.force, above->force, (base - below.base) / (above->base - below.base));
}

std::optional<SampledCycle> sampleCycle(const Scene& scene, const Vector2& base, double setpoint) {
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, base);
    const std::optional<Engagement> engaged = engage(path, setpoint);
    if (!engaged || !engaged->atSetpoint.state.converged) {
        return std::nullopt;
    }
    const TipAtHeight& pressed = engaged->atSetpoint;
    const std::optional<RetractCurve> curve = retract(path, pressed);
    if (!curve) {
        return std::nullopt;
    }
    const ContactState& contact = pressed.state.contact;
    const FoundJump& in = engaged->snapIn;
    const FoundJump& off = curve->pullOff;
    return SampledCycle{.pullOffForce = strongestPull(path, *curve),
                        .pullOffBase = off.base,
                        .snapInForce = std::max(0.0, -in.forceAfter()),
                        .snapInBase = in.base,
                        .setpointBase = pressed.base,
                        .indentation = contact.indentation,
                        .pulled = pulledFrom(contact, off),
                        .stiffness = contact.stiffness,
                        .separationWork = separationWork(*curve),
                        .setpoint = setpoint,
                        .approach = approachLine(path, *engaged, *curve),
                        .retract = retractLine(path, *curve)};
}

QuantityErrors errorsOf(const SampledCycle& cycle, const SampledCycle& reference) {
    const double force = kRounding * reference.setpoint;
    const double travel = reference.pullOffBase - reference.setpointBase;
    const double length = kRounding * travel;
    const auto moved = [&](double SampledCycle::*base) {
        return shareOf(cycle.*base, reference.*base, travel, length);
    };
    QuantityErrors errors;
    errors[JudgedQuantity::PullOffForce] =
        shareOf(cycle.pullOffForce, reference.pullOffForce, force);
    errors[JudgedQuantity::PullOffPosition] = moved(&SampledCycle::pullOffBase);
    errors[JudgedQuantity::SnapInForce] = shareOf(cycle.snapInForce, reference.snapInForce, force);
    errors[JudgedQuantity::SnapInPosition] = moved(&SampledCycle::snapInBase);
    // Under adhesion the indentation is a difference of two lengths and passes 0: as a share of
    // itself it says nothing there, within a tenth of what the retract takes away.
    constexpr double kNearZero = 0.1;
    errors[JudgedQuantity::Indentation] =
        shareOf(cycle.indentation, reference.indentation,
                std::max(std::abs(reference.indentation), kNearZero * reference.pulled), length);
    errors[JudgedQuantity::Stiffness] = shareOf(cycle.stiffness, reference.stiffness, 0.0);
    errors[JudgedQuantity::SeparationWork] =
        shareOf(cycle.separationWork, reference.separationWork, force * travel);
    errors[JudgedQuantity::RunForce] = rmsShare(cycle, reference);
    return errors;
}

double forceShare(std::span<const TipState> run, std::span<const TipState> reference) {
    const auto differs = [&](std::size_t tick) {
        return tick < run.size() && !isHeldAlike(run[tick], reference[tick]);
    };
    ForceSquares squares;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const double error = (run[i].force - reference[i].force).squaredNorm();
        squares.reference += reference[i].force.squaredNorm();
        if (!differs(i)) {
            squares.heldAlike += error;
        } else if (differs(i - 1) || differs(i + 1)) {
            squares.heldByOne += error;
        }
    }
    return squares.share();
}

SampledRuns::SampledRuns(Scene& scene, double longestTick, const Progress* progress)
    : scene_(scene), progress_(progress) {
    setModel(scene, usualModel(scene.description));  // the runs are the same whatever the reference
    const double duration = kTicksAPath * scene.timeStep();
    addRun(slidePath(scene, {.duration = duration}));
    usualTickTime_ = quantile(runModel(scene, runs_, progress_).times, 0.5);
    slow_ = usualTickTime_ > longestTick;
    if (slow_) {
        return;
    }
    const Vector2 size(scene.surface.sizeX(), scene.surface.sizeY());
    double depth = PathPlan{}.indentation;
    for (const Vector2& share : {Vector2(0.31, 0.62), Vector2(0.71, 0.27)}) {
        depth *= 0.5;  // the less a slide presses, the more adhesion weighs in its force
        addRun(slidePath(
            scene,
            {.duration = duration, .indentation = depth, .position = share.cwiseProduct(size)}));
    }
    addRun(rasterPath(scene, {.duration = duration}));
    positions_ = sampledPositions(scene);
}

void SampledRuns::addRun(const DevicePath& path) {
    runs_.push_back(recordInputs(scene_, path, kTicksAPath * scene_.timeStep(), progress_));
}

const ModelSample& SampledRuns::of(const ForceModelOptions& model) {
    setModel(scene_, model);
    const ForceModelOptions same = ofForce(model);
    const auto known = std::ranges::find(samples_, same, &ModelSample::model);
    if (known != samples_.end()) {
        return *known;
    }
    ModelSample sample{
        .model = same, .run = runModel(scene_, runs_, progress_), .tickTime = 0.0, .cycles = {}};
    sample.tickTime = quantile(sample.run.times, 0.5);
    for (const Vector2& position : positions_) {
        throwIfCanceled(progress_);
        sample.cycles.push_back(sampleCycle(scene_, position, scene_.description.setpoint));
    }
    return samples_.emplace_back(std::move(sample));
}

double SampledRuns::timeDifference(const ForceModelOptions& one, const ForceModelOptions& other) {
    const std::vector<ModelInputs> first(runs_.begin(), runs_.begin() + 1);
    const auto timeOf = [&](const ForceModelOptions& model) {
        setModel(scene_, model);
        return quantile(runModel(scene_, first, progress_).times, 0.5);
    };
    const double ofOther = timeOf(other);
    return timeOf(one) - ofOther;
}

QuantityErrors SampledRuns::errors(const ForceModelOptions& model,
                                   const ForceModelOptions& reference) {
    const ModelSample& exact = of(reference);
    const ModelSample& sample = of(model);
    QuantityErrors errors;
    for (std::size_t i = 0; i < exact.cycles.size(); ++i) {
        if (exact.cycles[i]) {
            errors.raiseTo(cycleErrors(sample.cycles[i], *exact.cycles[i]));
        }
    }
    std::size_t first = 0;
    for (const ModelInputs& run : runs_) {
        const std::size_t ticks = run.inputs.size();
        const double share = forceShare(std::span(sample.run.states).subspan(first, ticks),
                                        std::span(exact.run.states).subspan(first, ticks));
        errors[JudgedQuantity::RunForce] = std::max(errors[JudgedQuantity::RunForce], share);
        first += ticks;
    }
    return errors;
}

std::vector<Vector2> sampledPositions(const Scene& scene) {
    const ContactSites sites(scene);
    Chosen chosen(sites);
    if (!sites.all().empty()) {
        takeSpread(scene, chosen);
    }
    const Vector2 top = pathStart(scene, {}).head<2>();
    const HeightSample sample = scene.surface.at(top.x(), top.y());
    const PrincipalCurvatures bend = principalCurvatures(sample);
    chosen.take(
        sites.at(top, sample,
                 effectiveRadius(scene.belief.tipRadius(), bend.largest, bend.smallest).radius));
    std::vector<Vector2> positions = chosen.positions();
    if (sites.hollow()) {
        positions.push_back(*sites.hollow());
    }
    return positions;
}

}  // namespace asperity
