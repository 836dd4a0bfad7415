#pragma once

#include "core/deformation/SurfaceField.h"
#include "core/surface/BSplineSurface.h"
#include "ui/ColorRange.h"
#include "ui/ColorScale.h"
#include "ui/SurfaceLook.h"

#include <QColor>
#include <QImage>

#include <cstdint>
#include <vector>

namespace asperity {

/// A surface seen from above: in the colors of a quantity, and shaded as hills under light from the
/// upper left. The top of the image is the far side, large y.
/// Where the scan holds no data, hatched gray: heights there are filled in; likewise where a
/// quantity of a part of the surface misses a value. Beside that part it is plain gray. What
/// changes with the tip has no place here: then the colors are those of heights.
class ReliefImage {
public:
    /// Of nothing.
    ReliefImage() = default;

    /// Samples the surface, at most 512 times along either side, and colors it as it did before.
    void setSurface(const BSplineSurface& surface);
    /// @param field what the look's quantity is on the surface
    void setLook(const SurfaceLook& look, const SurfaceField& field);

    [[nodiscard]] const QImage& image() const { return image_; }
    /// Of the pixels, top row first [m].
    [[nodiscard]] const std::vector<double>& heights() const { return heights_; }
    [[nodiscard]] const ColorScale& colors() const { return colors_; }
    /// Whether the scan holds no data somewhere.
    [[nodiscard]] bool hasFilled() const { return hasFilled_; }
    /// Whether the quantity misses values in the part of the scan that it is of.
    [[nodiscard]] bool hasGaps() const { return field_.hasGaps(); }

private:
    [[nodiscard]] double xOf(int column) const;  ///< of a pixel's middle [m]
    [[nodiscard]] double yOf(int row) const;     ///< likewise
    [[nodiscard]] QColor colorOfNone(int row, int column) const;
    [[nodiscard]] std::vector<double> values() const;
    void paint();

    SurfaceLook look_;
    SurfaceField field_;
    ColorRanges ranges_;
    QImage image_;
    double sizeX_ = 0.0;  ///< of the scan [m]
    double sizeY_ = 0.0;  ///< [m]
    std::vector<double> heights_;
    std::vector<Vector3> normals_;        ///< of the pixels
    std::vector<float> shades_;           ///< brightness of the pixels, 1 for level ground
    std::vector<std::uint8_t> measured_;  ///< whether the scan holds data there
    ColorScale colors_;
    bool hasFilled_ = false;
};

/// Color of a pixel where the scan holds no data: gray stripes that run up to the right.
[[nodiscard]] QColor hatched(int row, int column);

}  // namespace asperity
