#pragma once

#include "core/curves/MeasuredForceCurve.h"
#include "core/io/curves/StoredCurves.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// All arrays of a segment.
inline constexpr std::array kCurveArrays{&CurveSegment::time,       &CurveSegment::base,
                                         &CurveSegment::separation, &CurveSegment::signal,
                                         &CurveSegment::deflection, &CurveSegment::force};

/// Returns what the segment says about the lever's load: its force, else its deflection, else its
/// signal; empty: none.
[[nodiscard]] const std::vector<double>& loadOf(const CurveSegment& segment);

/// Duration of a segment whose samples come in equal steps, the last one included [s]; NaN without
/// times.
[[nodiscard]] double durationOf(const CurveSegment& segment);

/// Sets the times of samples in equal steps. @param begin of the segment, duration [s]
void setUniformTimes(CurveSegment& segment, double begin, double duration, std::size_t points);

/// The kind that a name says: "extend-spm", "0:approach", "Retract"; `known` is set to whether it
/// says one. A dwell is a pause.
[[nodiscard]] CurveSegmentKind segmentKind(std::string_view name, bool& known);

/// Splits a single segment at its largest load, which still belongs to the approach.
void splitAtTurn(std::vector<CurveSegment>& segments);

/// Turns the base so that it grows towards the sample, where the load is largest.
void turnBase(std::vector<CurveSegment>& segments);

/// Brings what a reader took from a file into the form of a MeasuredForceCurve: leaves out samples
/// without a number and segments of fewer than two points, with a note, and computes deflection and
/// force where the file gives their factors.
/// @param file for messages @throw InputError where no segment is left
void finishCurve(CurveContents& contents, const std::string& file);

/// Returns the channel of the base: the one that the user names, else the first of them.
/// @throw InputError that lists them where the named one is not among them
[[nodiscard]] std::string chosenHeight(const std::vector<std::string>& heights,
                                       const std::string& wanted, const std::string& file);

}  // namespace asperity
