#include "ui/view/ViewExtent.h"

#include <algorithm>

namespace asperity {

namespace {

// In half widths of the frame.
constexpr double kBlockDepth = 0.12;
constexpr double kMinFloor = 0.05;  // of block below a dent

constexpr double kExtentStep = 1.5;  // a dent that needs more room gets so many times its depth

}  // namespace

void ViewExtent::fit(const FramedSurface& surface, double tipHeight, double dent) {
    const double slack = (kBlockDepth - kMinFloor) * surface.halfWidth / surface.heightScale;
    if (dent > slack) {  // else the block has room for it anyway
        dentDepth_ = std::max(dentDepth_, dent);
    }
    const double above = surface.heightScale * surface.heights.high - surface.middle();
    fitted_ = {.halfWidth = surface.halfWidth,
               .below = surface.middle() - drawnBottom(surface),
               .above = above,
               .tipTop = above + tipHeight};
    isFitWanted_ = false;
}

void ViewExtent::forget() {
    dentDepth_ = 0.0;
    lowered_ = 0.0;
    isFitWanted_ = true;
}

/// It does not shrink when the tip retracts.
bool ViewExtent::makeRoomFor(double lowest, const FramedSurface& surface) {
    const double floor = kMinFloor * surface.halfWidth / surface.heightScale;
    if (!(bottom(surface) + floor > lowest)) {
        return false;
    }
    dentDepth_ = kExtentStep * (surface.heights.low - lowest);
    return true;
}

double ViewExtent::drawnBottom(const FramedSurface& surface) const {
    return surface.heightScale * (surface.heights.low - dentDepth_) -
           kBlockDepth * surface.halfWidth;
}

double ViewExtent::bottom(const FramedSurface& surface) const {
    return drawnBottom(surface) / surface.heightScale;
}

FrameBox ViewExtent::box(const FramedSurface& surface, const Vector2& center) const {
    FrameBox box = fitted_;
    box.middle = {center.x(), center.y(), surface.middle() - lowered_};
    return box;
}

}  // namespace asperity
