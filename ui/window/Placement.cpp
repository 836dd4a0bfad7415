#include "ui/window/Placement.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr int kTitleBar = 36;  ///< of a window's frame, at most as desktops draw it [px]
constexpr int kBorder = 6;     ///< likewise, at each side [px]

/// What a frame leaves of the screen.
QRect inFrame(const QRect& available) {
    return available.adjusted(kBorder, kTitleBar, -kBorder, -kBorder);
}

}  // namespace

QRect openingPlace(const QSize& wanted, const QRect& available) {
    const QRect room = inFrame(available);
    QRect place({}, wanted.boundedTo(room.size()));
    place.moveCenter(room.center());
    return place;
}

QRect placeBeside(const QRect& window, const QSize& wanted, const QRect& available) {
    const QRect room = inFrame(available);
    QRect place({}, wanted.boundedTo(room.size()));
    const int gap = 2 * kBorder + 1;
    const int right = window.right() + gap;
    const int left = window.left() - gap - place.width() + 1;
    const bool fitsRight = right + place.width() - 1 <= room.right();
    place.moveLeft(fitsRight             ? right
                   : left >= room.left() ? left
                                         : room.right() - place.width() + 1);
    place.moveTop(std::clamp(window.top(), room.top(), room.bottom() - place.height() + 1));
    return place;
}

}  // namespace asperity
