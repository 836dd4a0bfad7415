#pragma once

#include "core/surface/HeightMap.h"

#include <string>
#include <vector>

namespace asperity {

/// One of the scans in data/samples.
struct SampleScan {
    std::string fileName;  ///< "particles.gsf"
    std::string title;
    HeightMap map;
    std::string unit = "m";  ///< empty: a mask, whose values are shares

    [[nodiscard]] bool isHeight() const { return unit == "m"; }
};

/// All scans of data/samples, generated: the same numbers on every call.
[[nodiscard]] std::vector<SampleScan> makeSampleScans();

}  // namespace asperity
