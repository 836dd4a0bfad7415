#pragma once

#include <string>

namespace asperity {

/// What a file does not say of an image that could be a height map.
struct ScaleGap {
    std::string channel;
    int columns = 0;
    int rows = 0;
    bool size = false;    ///< the size of the scan is unknown
    bool height = false;  ///< the values are numbers without unit
    bool mask = false;    ///< by its values it is a mask, no height map

    bool operator==(const ScaleGap&) const = default;
};

}  // namespace asperity
