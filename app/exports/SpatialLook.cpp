#include "app/exports/SpatialLook.h"

namespace asperity {

namespace {

// In pixels of letters.
constexpr double kLeastWidth = 480.0;
constexpr double kLeastHeight = 360.0;

std::optional<ViewDirection> sideOf(ExportView view) {
    switch (view) {
    case ExportView::Front:
        return ViewDirection::Front;
    case ExportView::Back:
        return ViewDirection::Back;
    case ExportView::Right:
        return ViewDirection::Right;
    case ExportView::Left:
        return ViewDirection::Left;
    case ExportView::Top:
        return ViewDirection::Top;
    case ExportView::Bottom:
        return ViewDirection::Bottom;
    default:
        return std::nullopt;
    }
}

}  // namespace

OffscreenZoomLook spatialLook(ExportView view, const PictureSpec& spec) {
    return {.size = spec.size,
            .look = spec.look(kLeastWidth, kLeastHeight),
            .parts = spec.parts,
            .side = sideOf(view),
            .section = view == ExportView::Section,
            .width = spec.width,
            .heightScale = spec.heightScale.value_or(1.0)};
}

}  // namespace asperity
