#pragma once

#include <string>

namespace asperity {

/// A named place on the sample, world frame, to travel to.
struct Marker {
    std::string name;
    double x = 0.0;  ///< [m]
    double y = 0.0;  ///< [m]

    bool operator==(const Marker&) const = default;
};

}  // namespace asperity
