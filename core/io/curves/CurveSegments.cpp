#include "core/io/curves/CurveSegments.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity {

namespace {

constexpr std::size_t kFewestPoints = 2;

/// Leaves out samples of which any array has no number.
void keepFinite(CurveSegment& segment) {
    const std::size_t points = loadOf(segment).size();
    std::vector<bool> kept(points, true);
    for (const auto array : kCurveArrays) {
        for (std::size_t i = 0; i < (segment.*array).size(); ++i) {
            kept[i] = kept[i] && std::isfinite((segment.*array)[i]);
        }
    }
    if (std::ranges::find(kept, false) == kept.end()) {
        return;
    }
    for (const auto array : kCurveArrays) {
        std::size_t index = 0;
        std::erase_if(segment.*array, [&](double /*value*/) { return !kept[index++]; });
    }
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> result(values.size());
    std::ranges::transform(values, result.begin(),
                           [factor](double value) { return factor * value; });
    return result;
}

void calibrate(CurveSegment& segment, const MeasuredForceCurve& curve) {
    if (segment.deflection.empty() && curve.invols > 0.0) {
        segment.deflection = scaled(segment.signal, curve.invols);
    }
    if (segment.force.empty() && curve.stiffness > 0.0) {
        segment.force = scaled(segment.deflection, curve.stiffness);
    }
}

std::string pointsText(std::size_t points) {
    return points == 0 ? "no point" : points == 1 ? "one point" : std::to_string(points);
}

/// Position of the largest load.
struct LoadPeak {
    double load = -std::numeric_limits<double>::infinity();
    double base = 0.0;
};

}  // namespace

const std::vector<double>& loadOf(const CurveSegment& segment) {
    return !segment.force.empty()        ? segment.force
           : !segment.deflection.empty() ? segment.deflection
                                         : segment.signal;
}

double durationOf(const CurveSegment& segment) {
    const auto points = static_cast<double>(segment.time.size());
    return points < 2.0 ? std::numeric_limits<double>::quiet_NaN()
                        : (segment.time.back() - segment.time.front()) * (points / (points - 1.0));
}

void setUniformTimes(CurveSegment& segment, double begin, double duration, std::size_t points) {
    segment.time.resize(points);
    const double step = duration / static_cast<double>(points);
    for (std::size_t i = 0; i < points; ++i) {
        segment.time[i] = begin + static_cast<double>(i) * step;
    }
}

CurveSegmentKind segmentKind(std::string_view text, bool& known) {
    const std::string name = lowerCase(text);
    const auto says = [&name](const char* word) { return name.find(word) != std::string::npos; };
    known = true;
    if (says("approach") || says("extend")) {
        return CurveSegmentKind::Approach;
    }
    if (says("retract")) {
        return CurveSegmentKind::Retract;
    }
    if (says("modulation")) {
        return CurveSegmentKind::Modulation;
    }
    known = says("pause") || says("dwell");
    return CurveSegmentKind::Pause;
}

void splitAtTurn(std::vector<CurveSegment>& segments) {
    CurveSegment& approach = segments.front();
    const std::vector<double>& load = loadOf(approach);
    const std::size_t kept =
        static_cast<std::size_t>(std::ranges::max_element(load) - load.begin()) + 1;
    if (kept >= load.size()) {
        return;
    }
    CurveSegment retract;
    retract.kind = CurveSegmentKind::Retract;
    for (const auto array : kCurveArrays) {
        std::vector<double>& from = approach.*array;
        if (!from.empty()) {
            const auto middle = from.begin() + static_cast<std::ptrdiff_t>(kept);
            (retract.*array).assign(middle, from.end());
            from.erase(middle, from.end());
        }
    }
    segments.push_back(std::move(retract));
}

void turnBase(std::vector<CurveSegment>& segments) {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    LoadPeak peak;
    for (const CurveSegment& segment : segments) {
        const std::vector<double>& load = loadOf(segment);
        for (std::size_t i = 0; i < segment.base.size(); ++i) {
            low = std::min(low, segment.base[i]);
            high = std::max(high, segment.base[i]);
            if (load[i] > peak.load) {
                peak = {load[i], segment.base[i]};
            }
        }
    }
    if (peak.base - low < high - peak.base) {
        for (CurveSegment& segment : segments) {
            for (double& base : segment.base) {
                base = -base;
            }
        }
    }
}

void finishCurve(CurveContents& contents, const std::string& file) {
    MeasuredForceCurve& curve = contents.curve;
    std::size_t number = 0;
    std::erase_if(curve.segments, [&](CurveSegment& segment) {
        keepFinite(segment);
        const std::size_t points = loadOf(segment).size();
        if (points < kFewestPoints) {
            contents.notes.push_back("segment " + std::to_string(number) + " (" +
                                     nameOf(segment.kind) + ") has " + pointsText(points) +
                                     " and was left out");
        }
        ++number;
        return points < kFewestPoints;
    });
    if (curve.segments.empty()) {
        throw InputError(file, "", "the curve has no segment of two points or more");
    }
    for (CurveSegment& segment : curve.segments) {
        calibrate(segment, curve);
    }
}

std::string chosenHeight(const std::vector<std::string>& heights, const std::string& wanted,
                         const std::string& file) {
    if (heights.empty()) {
        throw InputError(file, "", "the curve has no channel of a height");
    }
    if (wanted.empty()) {
        return heights.front();
    }
    if (std::ranges::count(heights, wanted) == 0) {
        std::string list;
        for (const std::string& height : heights) {
            list += (list.empty() ? "'" : "', '") + height;
        }
        throw InputError(file, "",
                         "there is no height channel '" + wanted + "': it has " + list + "'");
    }
    return wanted;
}

}  // namespace asperity
