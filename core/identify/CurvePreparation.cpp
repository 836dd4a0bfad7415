#include "core/identify/CurvePreparation.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::size_t kMinSamples = 20;
constexpr double kFarThird = 1.0 / 3.0;  ///< of the approach: its first baseline
constexpr double kFreeShare = 0.9;       ///< of the way to the contact: its baseline
constexpr double kTurned = 10.0;         ///< standard deviations that a turned-over force pulls

/// Sums for a line through points; offsets keep precision.
class LineFit {
public:
    LineFit(double xZero, double yZero) : xZero_(xZero), yZero_(yZero) {}

    void add(double x, double y) noexcept {
        const double dx = x - xZero_;
        const double dy = y - yZero_;
        count_ += 1.0;
        x_ += dx;
        y_ += dy;
        xx_ += dx * dx;
        xy_ += dx * dy;
        yy_ += dy * dy;
    }
    [[nodiscard]] double count() const noexcept { return count_; }
    [[nodiscard]] double slope() const noexcept {
        const double spread = xx_ - (x_ * x_ / count_);
        return spread > 0.0 ? (xy_ - (x_ * y_ / count_)) / spread : 0.0;
    }
    /// Value of the line of this slope at x = 0.
    [[nodiscard]] double offset(double slope) const noexcept {
        return yZero_ + (y_ / count_) - (slope * (xZero_ + (x_ / count_)));
    }
    /// Standard deviation about the line of this slope.
    [[nodiscard]] double scatter(double slope) const noexcept {
        const double yy = yy_ - (y_ * y_ / count_);
        const double xy = xy_ - (x_ * y_ / count_);
        const double xx = xx_ - (x_ * x_ / count_);
        const double squares = yy - (2.0 * slope * xy) + (slope * slope * xx);
        return std::sqrt(std::max(0.0, squares) / std::max(1.0, count_ - 2.0));
    }

private:
    double xZero_;
    double yZero_;
    double count_ = 0.0;
    double x_ = 0.0;
    double y_ = 0.0;
    double xx_ = 0.0;
    double xy_ = 0.0;
    double yy_ = 0.0;
};

double largestOf(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

/// A quantity of the segment that tells which approach presses most.
const std::vector<double>& loadOf(const CurveSegment& segment) {
    return !segment.force.empty()        ? segment.force
           : !segment.deflection.empty() ? segment.deflection
                                         : segment.signal;
}

/// Stiffness by which the file computed its forces from its deflections; 0: it has not both.
double stiffnessOf(const CurveSegment& segment) {
    if (segment.force.empty() || segment.deflection.empty()) {
        return 0.0;
    }
    LineFit line(segment.deflection.front(), segment.force.front());
    for (std::size_t i = 0; i < segment.force.size(); ++i) {
        line.add(segment.deflection[i], segment.force[i]);
    }
    return line.slope();
}

/// The calibration of a lever, and how a segment's deflection follows from what is stored.
struct LeverCalibrated {
    double stiffness = 0.0;
    ValueSource stiffnessSource = ValueSource::File;
    double fileStiffness = 0.0;  ///< with which the file's forces were computed; 0: unknown
    double invols = 0.0;
    double involsFactor = 1.0;  ///< of the stored deflection
};

LeverCalibrated calibrationOf(const MeasuredForceCurve& curve, const CurveSegment& approach,
                              const PreparationOptions& options) {
    LeverCalibrated lever;
    lever.fileStiffness = curve.stiffness > 0.0 ? curve.stiffness : stiffnessOf(approach);
    lever.stiffness = options.stiffness > 0.0 ? options.stiffness : lever.fileStiffness;
    lever.stiffnessSource = options.stiffness > 0.0 ? options.stiffnessSource : ValueSource::File;
    lever.invols = options.invols > 0.0 ? options.invols : curve.invols;
    if (!(lever.stiffness > 0.0)) {
        throw CurveRefusal("the spring constant is missing: give --stiffness");
    }
    const bool isVolts = approach.deflection.empty() && approach.force.empty();
    if (isVolts && !(lever.invols > 0.0)) {
        throw CurveRefusal("the InvOLS is missing, and the signal is in volts: give --invols");
    }
    if (!isVolts && options.invols > 0.0) {
        if (!(curve.invols > 0.0) && approach.signal.empty()) {
            throw CurveRefusal("--invols cannot correct this curve: its file does not say with "
                               "which InvOLS its deflection was computed");
        }
        lever.involsFactor = curve.invols > 0.0 ? options.invols / curve.invols : 1.0;
    }
    return lever;
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(),
                   [factor](double value) { return value * factor; });
    return result;
}

BranchSamples branchOf(const CurveSegment& segment, const LeverCalibrated& lever,
                       const PreparationOptions& options) {
    BranchSamples branch;
    branch.time = segment.time;
    const bool fromVolts =
        !segment.signal.empty() && lever.invols > 0.0 &&
        (options.invols > 0.0 || loadOf(segment).data() == segment.signal.data());
    if (fromVolts) {
        branch.force = scaled(segment.signal, lever.invols * lever.stiffness);
    } else if (!segment.deflection.empty()) {
        branch.force = scaled(segment.deflection, lever.involsFactor * lever.stiffness);
    } else {
        const double own = lever.fileStiffness > 0.0 ? lever.stiffness / lever.fileStiffness : 1.0;
        branch.force = scaled(segment.force, lever.involsFactor * own);
    }
    branch.base = segment.base;
    if (segment.base.empty()) {
        branch.base.resize(segment.separation.size());
        for (std::size_t i = 0; i < branch.base.size(); ++i) {
            branch.base[i] = (branch.force[i] / lever.stiffness) - segment.separation[i];
        }
    }
    return branch;
}

void append(BranchSamples& all, const BranchSamples& more) {
    all.time.insert(all.time.end(), more.time.begin(), more.time.end());
    all.base.insert(all.base.end(), more.base.begin(), more.base.end());
    all.force.insert(all.force.end(), more.force.begin(), more.force.end());
}

std::vector<CurveSegment>::const_iterator deepestApproach(const MeasuredForceCurve& curve) {
    auto found = curve.segments.end();
    for (auto segment = curve.segments.begin(); segment != curve.segments.end(); ++segment) {
        const bool counts =
            segment->kind == CurveSegmentKind::Approach && loadOf(*segment).size() >= kMinSamples;
        if (counts && (found == curve.segments.end() ||
                       largestOf(loadOf(*segment)) > largestOf(loadOf(*found)))) {
            found = segment;
        }
    }
    if (found == curve.segments.end()) {
        throw CurveRefusal("no approach of at least 20 samples");
    }
    return found;
}

CurveBaseline lineUpTo(const BranchSamples& approach, double nearEnd, bool tilt) {
    LineFit line(approach.base.front(), approach.force.front());
    double differences = 0.0;
    double pairs = 0.0;
    for (std::size_t i = 0; i < approach.size(); ++i) {
        if (approach.base[i] > nearEnd) {
            continue;
        }
        line.add(approach.base[i], approach.force[i]);
        if (i > 0) {
            const double step = approach.force[i] - approach.force[i - 1];
            differences += step * step;
            pairs += 1.0;
        }
    }
    CurveBaseline result;
    result.slope = tilt ? line.slope() : 0.0;
    result.offset = line.offset(result.slope);
    result.noise = line.scatter(result.slope);
    result.pointNoise = std::sqrt(0.5 * differences / std::max(1.0, pairs));
    result.nearEnd = nearEnd;
    return result;
}

std::vector<double> forceAbove(const BranchSamples& branch, const CurveBaseline& line,
                               double offset) {
    std::vector<double> result(branch.size());
    for (std::size_t i = 0; i < branch.size(); ++i) {
        result[i] = branch.force[i] - line.at(branch.base[i]) - offset;
    }
    return result;
}

/// Base at which the smoothed force first leaves the noise of a line, in either direction: the last
/// one where it never does.
double departureOf(const BranchSamples& approach, const std::vector<double>& force,
                   const CurveBaseline& line) {
    constexpr double kDeparture = 6.0;
    constexpr double kRounding = 1e-9;  // of the range: numbers of a file have few digits
    constexpr std::size_t kWindows = 400;
    const std::size_t width = 3 + (approach.size() / kWindows);
    const double least = std::max(kDeparture * line.noise, kRounding * approach.forceRange());
    double sum = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        sum += force[i] - (i >= width ? force[i - width] : 0.0);
        if (i >= width && std::abs(sum) > least * static_cast<double>(width)) {
            return approach.base[i - width];
        }
    }
    return *std::max_element(approach.base.begin(), approach.base.end());
}

/// Force above the baseline where the base is deepest.
double deepestForce(const BranchSamples& approach, const CurveBaseline& line) {
    const auto deepest = std::max_element(approach.base.begin(), approach.base.end());
    const auto index = static_cast<std::size_t>(deepest - approach.base.begin());
    return approach.force[index] - line.at(*deepest);
}

LineFit upperPart(const BranchSamples& branch, const std::vector<double>& force, double stiffness) {
    constexpr double kLower = 0.2;
    const double largest = largestOf(force);
    LineFit line(branch.base.front(), 0.0);
    for (std::size_t i = 0; i < branch.size(); ++i) {
        if (force[i] > kLower * largest) {
            line.add(branch.base[i], force[i] / stiffness);
        }
    }
    return line;
}

void turnOver(BranchSamples& branch) {
    for (double& force : branch.force) {
        force = -force;
    }
}

/// Corrects force and stiffness for an InvOLS that is `gain` times the stored one.
void applyGain(PreparedCurve& curve, double gain, LeverRule rule) {
    const bool thermal = rule == LeverRule::Thermal;
    const double factor = thermal ? 1.0 / gain : gain;
    curve.gain = gain;
    curve.stiffness *= thermal ? 1.0 / (gain * gain) : 1.0;
    for (BranchSamples* branch : {&curve.approach, &curve.dwell, &curve.retract}) {
        branch->force = scaled(branch->force, factor);
    }
    curve.baseline.offset *= factor;
    curve.baseline.slope *= factor;
    curve.baseline.noise *= factor;
    curve.baseline.pointNoise *= factor;
    curve.baseline.retractOffset *= factor;
}

IdentifiedValue measured(const char* key, double value, const char* unit) {
    return {.key = key, .value = value, .unit = unit, .source = ValueSource::Measured};
}

void addLeverSteps(PreparedCurve& curve, const LeverCalibrated& lever,
                   const PreparationOptions& options) {
    PreparationStep step{.key = "lever"};
    step.values.push_back({.key = "stiffness_n_m",
                           .value = lever.stiffness,
                           .unit = "N/m",
                           .source = lever.stiffnessSource});
    if (lever.invols > 0.0) {
        step.values.push_back(
            {.key = "invols_m_v",
             .value = lever.invols,
             .unit = "m/V",
             .source = options.invols > 0.0 ? ValueSource::Assumed : ValueSource::File});
    }
    curve.steps.push_back(std::move(step));
    curve.steps.push_back({.key = "sign",
                           .on = options.sign,
                           .note = curve.turnedOver ? "the force was negative in contact: turned "
                                                      "over"
                                                    : ""});
}

void addBaselineSteps(PreparedCurve& curve, const PreparationOptions& options) {
    const CurveBaseline& line = curve.baseline;
    curve.steps.push_back(
        {.key = "baseline",
         .on = options.baseline,
         .values = {measured("offset_n", line.offset, "N"), measured("noise_n", line.noise, "N")},
         .note = line.isWavy() ? "the residual of the line exceeds three times "
                                 "the point noise: interference or drift"
                               : ""});
    curve.steps.push_back({.key = "tilt",
                           .on = options.baseline && options.tilt,
                           .values = {measured("slope_n_m", line.slope, "N/m")}});
    curve.steps.push_back({.key = "drag",
                           .on = options.baseline && options.drag && curve.retract.size() > 0,
                           .values = {measured("drag_n", line.drag(), "N")}});
}

void addSlopeSteps(PreparedCurve& curve, const PreparationOptions& options) {
    const ContactSlope& slope = curve.slope;
    curve.steps.push_back({.key = "contact_slope",
                           .values = {measured("approach", slope.approach, ""),
                                      measured("retract", slope.retract, ""),
                                      measured("unevenness", slope.unevenness, "")}});
    PreparationStep step{.key = "invols_gain", .on = options.lever != LeverRule::AsInFile};
    if (step.on && slope.isRigid()) {
        applyGain(curve, 1.0 / slope.approach, options.lever);
    } else if (step.on) {
        step.note = "not applied: the contact is not straight within 1 % and alike on both "
                    "branches, so its slope is not the lever's alone";
    }
    step.values.push_back(measured("invols_gain", curve.gain, ""));
    curve.steps.push_back(std::move(step));
}

}  // namespace

double BranchSamples::forceRange() const {
    const auto [low, high] = std::minmax_element(force.begin(), force.end());
    return force.empty() ? 0.0 : *high - *low;
}

bool ContactSlope::isRigid() const noexcept {
    constexpr double kStraight = 0.01;
    constexpr double kAlike = 0.03;
    const bool alike = retract == 0.0 || std::abs(approach - retract) < kAlike * approach;
    return approach > 0.0 && unevenness < kStraight && alike;
}

std::vector<double> PreparedCurve::correctedForce(const BranchSamples& branch) const {
    return forceAbove(branch, baseline, &branch == &retract ? baseline.retractOffset : 0.0);
}

double PreparedCurve::forceRange() const {
    const auto [low, high] = std::minmax_element(approach.force.begin(), approach.force.end());
    double least = *low;
    double most = *high;
    for (const double force : retract.force) {
        least = std::min(least, force);
        most = std::max(most, force);
    }
    return most - least;
}

CurveBaseline baselineOf(const BranchSamples& approach, bool tilt) {
    const auto [far, deep] = std::minmax_element(approach.base.begin(), approach.base.end());
    const CurveBaseline first = lineUpTo(approach, *far + (kFarThird * (*deep - *far)), tilt);
    const double departure = departureOf(approach, forceAbove(approach, first, 0.0), first);
    const double nearEnd = *far + (kFreeShare * (departure - *far));
    return nearEnd > first.nearEnd ? lineUpTo(approach, nearEnd, tilt) : first;
}

double retractOffset(const BranchSamples& retract, const CurveBaseline& baseline) {
    if (retract.size() == 0) {
        return 0.0;
    }
    // From the far end inwards, until the force leaves the level there: a neck may hold the tip
    // farther out than the approach was attracted.
    constexpr double kLevel = 6.0;
    constexpr double kRounding = 1e-9;
    const double level = std::max(kLevel * baseline.noise, kRounding * retract.forceRange());
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = retract.size(); i-- > 0 && retract.base[i] <= baseline.nearEnd;) {
        const double above = retract.force[i] - baseline.at(retract.base[i]);
        if (count > 0.0 && std::abs(above - (sum / count)) > level) {
            break;
        }
        sum += above;
        count += 1.0;
    }
    return count >= static_cast<double>(kMinSamples) ? sum / count : 0.0;
}

ContactSlope contactSlope(const PreparedCurve& curve) {
    const LineFit approach =
        upperPart(curve.approach, curve.correctedForce(curve.approach), curve.stiffness);
    ContactSlope result;
    result.approach = approach.slope();
    const double range = curve.approach.forceRange() / curve.stiffness;
    result.unevenness = range > 0.0 ? approach.scatter(result.approach) / range : 0.0;
    if (curve.retract.size() >= kMinSamples) {
        result.retract =
            upperPart(curve.retract, curve.correctedForce(curve.retract), curve.stiffness).slope();
    }
    return result;
}

PreparedCurve prepareCurve(const MeasuredForceCurve& curve, const PreparationOptions& options) {
    const auto approach = deepestApproach(curve);
    const LeverCalibrated lever = calibrationOf(curve, *approach, options);
    PreparedCurve result;
    result.stiffness = lever.stiffness;
    result.approach = branchOf(*approach, lever, options);
    const auto retract =
        std::find_if(approach, curve.segments.end(), [](const CurveSegment& segment) {
            return segment.kind == CurveSegmentKind::Retract && loadOf(segment).size() > 1;
        });
    if (retract != curve.segments.end()) {
        result.retract = branchOf(*retract, lever, options);
        for (auto pause = approach + 1; pause < retract; ++pause) {
            append(result.dwell, branchOf(*pause, lever, options));
        }
    }
    result.baseline = baselineOf(result.approach, options.tilt);
    const double deepest = deepestForce(result.approach, result.baseline);
    if (options.sign && deepest < -kTurned * result.baseline.noise) {
        result.turnedOver = true;
        turnOver(result.approach);
        turnOver(result.dwell);
        turnOver(result.retract);
        result.baseline = baselineOf(result.approach, options.tilt);
    }
    if (!options.baseline) {
        result.baseline.offset = 0.0;
        result.baseline.slope = 0.0;
    } else if (options.drag) {
        result.baseline.retractOffset = retractOffset(result.retract, result.baseline);
    }
    result.slope = contactSlope(result);
    addLeverSteps(result, lever, options);
    addBaselineSteps(result, options);
    addSlopeSteps(result, options);
    return result;
}

}  // namespace asperity
