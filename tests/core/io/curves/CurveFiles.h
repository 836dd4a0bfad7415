#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace asperity::test {

/// A segment of a JPK archive of the dialect with a shared header: a height in metres and a
/// deflection in volts, of 16 bits each.
struct JpkSegmentText {
    std::string style = "extend";
    std::vector<std::int16_t> height{400, 300, 200, 100};
    std::vector<std::int16_t> deflection{0, 0, 5, 10};
    std::string duration = "2.0";
    std::string points = "4";
    bool hasDeflectionFile = true;
};

/// A JPK archive of force curves: 1 nm and 10 mV a count, 50 nm/V, 0.1 N/m.
struct JpkCurveText {
    /// Members of the curves by their folder, "" or "index/3/".
    std::map<std::string, std::vector<JpkSegmentText>> curves;
    /// Lines of the shared header that replace those with the same key.
    std::map<std::string, std::string> shared;
};
[[nodiscard]] std::string jpkCurveFile(const JpkCurveText& text);

/// An approach and a retract.
[[nodiscard]] std::vector<JpkSegmentText> jpkCycle();

/// A NanoScope file of force curves of 4 + 4 samples each: 1 mV a count, 30 nm/V, 0.2 N/m, a ramp
/// of 400 nm, 100 and 200 nm/s.
struct NanoscopeCurveText {
    std::string version = "0x08000000";
    std::string context = "FOL";
    std::string rampSize = "V [Sens. Zsens] (0.006 V/LSB) 40.0 V";
    std::string zScale = "V [Sens. DeflSens] (0.001 V/LSB) 2.5 V";
    std::string counts = "4 4";
    int width = 2;       ///< of a sample [bytes]
    int perLine = 1;     ///< curves of a line
    int dataLength = 0;  ///< 0: that of the samples
    std::vector<std::int32_t> samples{10, 5, 0, 0, 9, 4, -2, 0};
};
[[nodiscard]] std::string nanoscopeCurveFile(const NanoscopeCurveText& text);

}  // namespace asperity::test
