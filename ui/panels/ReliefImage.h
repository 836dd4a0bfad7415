#pragma once

#include "core/surface/BSplineSurface.h"
#include "ui/ColorScale.h"

#include <QColor>
#include <QImage>

#include <vector>

namespace asperity {

/// A surface seen from above: colored by height and shaded as hills under light from the upper
/// left. The top of the image is the far side, large y.
/// Where the scan holds no data, hatched gray: heights there are filled in.
struct ReliefImage {
    QImage image;                 ///< at most 512 pixels along either side
    std::vector<double> heights;  ///< of the pixels, top row first [m]
    ColorScale colors;            ///< from the lowest to the highest height drawn
    bool hasFilled = false;       ///< whether the scan holds no data somewhere
};

/// Color of a pixel where the scan holds no data: gray stripes that run up to the right.
[[nodiscard]] QColor hatched(int row, int column);

[[nodiscard]] ReliefImage reliefImage(const BSplineSurface& surface);

}  // namespace asperity
