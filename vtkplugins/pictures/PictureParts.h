#pragma once

namespace asperity {

/// What stands in a picture besides what it shows.
struct PictureParts {
    bool bars = true;    ///< scale bars, color bars, axes
    bool labels = true;  ///< title, legend, caption, names and values
    bool grid = true;    ///< lines on the surface

    bool operator==(const PictureParts&) const = default;
};

}  // namespace asperity
