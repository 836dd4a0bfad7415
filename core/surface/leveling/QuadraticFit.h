#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <array>

namespace asperity {

/// A polynomial of second degree through the heights of a map, relative to the map's datum.
class QuadraticFit {
public:
    /// The least-squares one of the valid pixels; where they do not determine it, the smallest.
    /// @throw Error when the map is unusable or no pixel is valid; Canceled
    template <class Heights>
    explicit QuadraticFit(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

    /// Height at the center of the pixel (row, column), row 0 at the top [m].
    [[nodiscard]] double at(int row, int column) const {
        const double u = (column - middleColumn_) / halfColumns_;
        const double v = (middleRow_ - row) / halfRows_;
        return origin_ + terms_[0] + u * (terms_[1] + terms_[3] * u + terms_[4] * v) +
               v * (terms_[2] + terms_[5] * v);
    }

    /// At the center of the scan, world frame.
    [[nodiscard]] double height() const { return origin_ + terms_[0]; }  ///< [m]
    [[nodiscard]] double slopeX() const { return terms_[1] / halfWidth_; }
    [[nodiscard]] double slopeY() const { return terms_[2] / halfHeight_; }
    /// Second derivatives [1/m].
    [[nodiscard]] double bendX() const { return 2.0 * terms_[3] / (halfWidth_ * halfWidth_); }
    [[nodiscard]] double bendY() const { return 2.0 * terms_[5] / (halfHeight_ * halfHeight_); }
    [[nodiscard]] double twist() const { return terms_[4] / (halfWidth_ * halfHeight_); }

private:
    double middleColumn_;
    double middleRow_;
    double halfColumns_;  ///< u and v are places over these: -1 to 1
    double halfRows_;
    double halfWidth_;   ///< [m]
    double halfHeight_;  ///< [m]
    double origin_;      ///< [m]
    /// Of 1, u, v, u^2, u v, v^2 [m].
    std::array<double, 6> terms_{};
};

}  // namespace asperity
