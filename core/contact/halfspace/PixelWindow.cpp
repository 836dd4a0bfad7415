#include "core/contact/halfspace/PixelWindow.h"

#include "core/contact/halfspace/FieldConvolution.h"

#include <algorithm>

namespace asperity {

void PixelBounds::include(int row, int column) noexcept {
    lowRow = std::min(lowRow, row);
    highRow = std::max(highRow, row);
    lowColumn = std::min(lowColumn, column);
    highColumn = std::max(highColumn, column);
}

void PixelBounds::include(const PixelBounds& others) noexcept {
    if (!others.empty()) {
        include(others.lowRow, others.lowColumn);
        include(others.highRow, others.highColumn);
    }
}

bool PixelBounds::within(const PixelWindow& window, int margin) const noexcept {
    return lowRow >= window.row + margin && lowColumn >= window.column + margin &&
           highRow < window.row + window.size - margin &&
           highColumn < window.column + window.size - margin;
}

PixelWindow windowAround(const PixelBounds& bounds, int samples) noexcept {
    constexpr int kMinMargin = 2;
    constexpr int kMarginShare = 16;  // of the pixels across
    const int across =
        std::max(bounds.highRow - bounds.lowRow, bounds.highColumn - bounds.lowColumn) + 1;
    const int margin = kMinMargin + across / kMarginShare;
    const int size = std::min(fieldSize(across + 2 * margin), fieldSize(samples));
    const auto first = [&](int low, int high) {
        const int centerd = (low + high + 1 - size) / 2;
        return std::clamp(centerd, std::min(0, samples - size), std::max(0, samples - size));
    };
    return {.row = first(bounds.lowRow, bounds.highRow),
            .column = first(bounds.lowColumn, bounds.highColumn),
            .size = size};
}

}  // namespace asperity
