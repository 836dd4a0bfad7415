#include "vtkplugins/pictures/RasterImage.h"

#include "core/Error.h"

namespace asperity {

RasterImage stacked(RasterImage above, const RasterImage& below) {
    if (above.width != below.width) {
        throw Error("Pictures of different widths cannot be put above each other.");
    }
    above.height += below.height;
    above.pixels.insert(above.pixels.end(), below.pixels.begin(), below.pixels.end());
    return above;
}

}  // namespace asperity
