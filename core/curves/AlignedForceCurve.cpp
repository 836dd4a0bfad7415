#include "core/curves/AlignedForceCurve.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::size_t kMinPoints = 20;
constexpr double kFarShare = 1.0 / 3.0;  ///< of the approach's way: its baseline
constexpr double kMinContact = 10.0;     ///< standard deviations that a contact must push
constexpr double kPull = 5.0;            ///< standard deviations: it pulls
constexpr double kRounding = 1e-12;      ///< of the largest force: below, it is that of the numbers

/// A line force = offset + slope * base, with the scatter about it.
struct Baseline {
    double offset = 0.0;  ///< [N]
    double slope = 0.0;   ///< [N/m]
    double sigma = 0.0;   ///< [N]

    [[nodiscard]] double at(double base) const { return offset + slope * base; }
};

/// Position of the base, or of the tip in its stead, on the way to the sample [m].
double positionOf(const CurveSegment& segment, std::size_t i) {
    return segment.base.empty() ? -segment.separation[i] : segment.base[i];
}

Baseline fitLine(const CurveSegment& segment, double farEnd, double nearEnd) {
    double n = 0.0;
    double meanPosition = 0.0;
    double meanForce = 0.0;
    for (std::size_t i = 0; i < segment.force.size(); ++i) {
        if (positionOf(segment, i) <= nearEnd) {
            n += 1.0;
            meanPosition += positionOf(segment, i) - farEnd;
            meanForce += segment.force[i];
        }
    }
    meanPosition = farEnd + meanPosition / n;
    meanForce /= n;
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < segment.force.size(); ++i) {
        const double position = positionOf(segment, i) - meanPosition;
        if (positionOf(segment, i) <= nearEnd) {
            xx += position * position;
            xy += position * (segment.force[i] - meanForce);
        }
    }
    Baseline line{.slope = xx > 0.0 ? xy / xx : 0.0};
    line.offset = meanForce - line.slope * meanPosition;
    double scatter = 0.0;
    for (std::size_t i = 0; i < segment.force.size(); ++i) {
        if (positionOf(segment, i) <= nearEnd) {
            const double rest = segment.force[i] - line.at(positionOf(segment, i));
            scatter += rest * rest;
        }
    }
    line.sigma = std::sqrt(scatter / std::max(1.0, n - 2.0));
    return line;
}

double maxForce(const CurveSegment& segment) {
    return *std::max_element(segment.force.begin(), segment.force.end());
}

/// The approach that pushes most; the end of the list: there is none.
std::vector<CurveSegment>::const_iterator mainApproach(const MeasuredForceCurve& curve) {
    auto found = curve.segments.end();
    for (auto segment = curve.segments.begin(); segment != curve.segments.end(); ++segment) {
        const bool counts =
            segment->kind == CurveSegmentKind::Approach && segment->force.size() >= kMinPoints;
        if (counts && (found == curve.segments.end() || maxForce(*segment) > maxForce(*found))) {
            found = segment;
        }
    }
    return found;
}

/// Stiffness of the lever by the curve's force and deflection, or as the file says; 0: unknown.
double stiffnessIn(const MeasuredForceCurve& curve, const CurveSegment& approach) {
    if (curve.stiffness > 0.0 || approach.deflection.empty()) {
        return curve.stiffness;
    }
    const auto count = static_cast<double>(approach.force.size());
    double meanForce = 0.0;
    double meanDeflection = 0.0;
    for (std::size_t i = 0; i < approach.force.size(); ++i) {
        meanForce += approach.force[i] / count;
        meanDeflection += approach.deflection[i] / count;
    }
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < approach.force.size(); ++i) {
        const double deflection = approach.deflection[i] - meanDeflection;
        product += deflection * (approach.force[i] - meanForce);
        square += deflection * deflection;
    }
    return square > 0.0 ? product / square : 0.0;
}

/// Returns where the force above the baseline last passes zero before its maximum.
double contactPosition(const CurveSegment& approach, const Baseline& baseline) {
    const auto above = [&](std::size_t i) {
        return approach.force[i] - baseline.at(positionOf(approach, i));
    };
    std::size_t peak = 0;
    for (std::size_t i = 1; i < approach.force.size(); ++i) {
        peak = above(i) > above(peak) ? i : peak;
    }
    if (!(above(peak) > kMinContact * baseline.sigma)) {
        throw Error("the approach of this curve shows no contact: its force rises by less than ten "
                    "standard deviations of its noise");
    }
    // Without noise the force on the baseline is zero only to the rounding of the fit.
    const double zero = kRounding * above(peak);
    std::size_t last = peak;
    while (last > 0 && above(last) > zero) {
        --last;
    }
    if (!(above(last) <= zero)) {
        throw Error("this curve has no contact point: its force is repulsive from the start");
    }
    const double share = std::max(0.0, -above(last)) / (above(last + 1) - above(last));
    return positionOf(approach, last) +
           share * (positionOf(approach, last + 1) - positionOf(approach, last));
}

/// @param contact of positionOf() [m]
AlignedBranch branchOf(const CurveSegment& segment, const Baseline& baseline, double contact,
                       double stiffness) {
    AlignedBranch branch;
    for (std::size_t i = 0; i < segment.force.size(); ++i) {
        const double force = segment.force[i] - baseline.at(positionOf(segment, i));
        const double distance = contact - positionOf(segment, i);
        const double deflection = force / stiffness;
        branch.force.push_back(force);
        branch.separation.push_back(segment.base.empty() ? distance : distance + deflection);
        branch.baseDistance.push_back(segment.base.empty() ? distance - deflection : distance);
    }
    return branch;
}

/// The same line, moved to the retract's own far end where that lies in the baseline's range.
Baseline ownBaseline(const CurveSegment& retract, const Baseline& baseline, double farthest,
                     double nearEnd) {
    double sum = 0.0;
    double count = 0.0;
    bool reachesFar = false;
    for (std::size_t i = 0; i < retract.force.size(); ++i) {
        const double position = positionOf(retract, i);
        reachesFar = reachesFar || position <= 0.5 * (farthest + nearEnd);
        if (position <= 0.5 * (farthest + nearEnd)) {
            sum += retract.force[i] - baseline.at(position);
            count += 1.0;
        }
    }
    Baseline own = baseline;
    own.offset += reachesFar ? sum / count : 0.0;
    return own;
}

double lastPullOf(const AlignedBranch& branch, double noise) {
    double largest = 0.0;
    for (const double force : branch.force) {
        largest = std::max(largest, std::abs(force));
    }
    const double least = std::max(kPull * noise, kRounding * largest);
    double last = 0.0;
    for (std::size_t i = 0; i < branch.force.size(); ++i) {
        if (branch.force[i] < -least) {
            last = std::max(last, branch.baseDistance[i]);
        }
    }
    return last;
}

}  // namespace

AlignedForceCurve alignedCurve(const MeasuredForceCurve& curve, double stiffness) {
    if (!curve.segments.empty() &&
        std::ranges::all_of(curve.segments,
                            [](const CurveSegment& segment) { return segment.force.empty(); })) {
        throw Error("this curve has no force: the lever's spring constant or its optical "
                    "sensitivity is missing");
    }
    const auto approach = mainApproach(curve);
    if (approach == curve.segments.end()) {
        throw Error("this curve has no approach of at least 20 points");
    }
    double farthest = positionOf(*approach, 0);
    double deepest = farthest;
    for (std::size_t i = 0; i < approach->force.size(); ++i) {
        farthest = std::min(farthest, positionOf(*approach, i));
        deepest = std::max(deepest, positionOf(*approach, i));
    }
    const double nearEnd = farthest + kFarShare * (deepest - farthest);
    const Baseline baseline = fitLine(*approach, farthest, nearEnd);
    const double measured = stiffnessIn(curve, *approach);
    const double contact = contactPosition(*approach, baseline);
    AlignedForceCurve aligned{.approach = {},
                              .retract = {},
                              .baselineForce = baseline.at(contact),
                              .baselineSlope = baseline.slope,
                              .retractOffset = 0.0,
                              .noise = baseline.sigma,
                              .stiffness = measured > 0.0 ? measured : stiffness,
                              .lastPull = 0.0};
    aligned.approach = branchOf(*approach, baseline, contact, aligned.stiffness);
    const auto retract =
        std::find_if(approach, curve.segments.end(), [](const CurveSegment& segment) {
            return segment.kind == CurveSegmentKind::Retract;
        });
    if (retract != curve.segments.end()) {
        const Baseline own = ownBaseline(*retract, baseline, farthest, nearEnd);
        aligned.retract = branchOf(*retract, own, contact, aligned.stiffness);
        aligned.retractOffset = own.offset - baseline.offset;
    }
    aligned.lastPull = std::max(lastPullOf(aligned.approach, aligned.noise),
                                lastPullOf(aligned.retract, aligned.noise));
    return aligned;
}

}  // namespace asperity
