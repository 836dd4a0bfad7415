#pragma once

#include "vtkplugins/pictures/Painter.h"

#include <vector>

namespace asperity {

/// Finds room for the names of dots, clear of dots, lines and one another.
class LabelPlacer {
public:
    LabelPlacer(const PixelRect& inside, double dotSize) : inside_(inside), dotSize_(dotSize) {}

    void blockDot(const PixelPoint& dot);
    void blockLine(const PixelPoint& from, const PixelPoint& to);

    /// The first place about the dot that is inside and free, else the one on its right.
    PixelRect place(const PixelPoint& dot, double width, double height);

private:
    [[nodiscard]] bool isFree(const PixelRect& place) const;

    PixelRect inside_;
    double dotSize_;
    std::vector<PixelRect> taken_;
};

}  // namespace asperity
