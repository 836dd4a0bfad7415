#include "vtkplugins/pictures/LabelPlacer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

void LabelPlacer::blockDot(const PixelPoint& dot) {
    taken_.push_back({dot.x - 0.5 * dotSize_, dot.y - 0.5 * dotSize_, dotSize_, dotSize_});
}

void LabelPlacer::blockLine(const PixelPoint& from, const PixelPoint& to) {
    constexpr double kBead = 4.0;  // a line is blocked as a string of beads of this size
    const int beads = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / kBead) + 1;
    for (int bead = 0; bead <= beads; ++bead) {
        const double part = static_cast<double>(bead) / beads;
        taken_.push_back({std::lerp(from.x, to.x, part) - 0.5 * kBead,
                          std::lerp(from.y, to.y, part) - 0.5 * kBead, kBead, kBead});
    }
}

PixelRect LabelPlacer::place(const PixelPoint& dot, double width, double height) {
    const double right = dot.x + dotSize_;
    const double left = dot.x - dotSize_ - width;
    const double middle = dot.x - 0.5 * width;
    const double above = dot.y + 0.7 * dotSize_;
    const double below = dot.y - 0.7 * dotSize_ - height;
    const double level = dot.y - 0.5 * height;
    const std::array<PixelPoint, 8> corners{{{right, level},
                                             {right, above},
                                             {right, below},
                                             {left, level},
                                             {left, above},
                                             {left, below},
                                             {middle, above},
                                             {middle, below}}};
    PixelRect found{right, level, width, height};
    for (const PixelPoint& corner : corners) {
        const PixelRect candidate{corner.x, corner.y, width, height};
        if (isFree(candidate)) {
            found = candidate;
            break;
        }
    }
    taken_.push_back(found);
    return found;
}

bool LabelPlacer::isFree(const PixelRect& place) const {
    return place.left >= inside_.left && place.right() <= inside_.right() &&
           place.bottom >= inside_.bottom && place.top() <= inside_.top() &&
           std::none_of(taken_.begin(), taken_.end(),
                        [&place](const PixelRect& other) { return place.overlaps(other); });
}

}  // namespace asperity
