#pragma once

#include "core/deformation/SurfaceField.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"
#include "ui/view/ColorScale.h"

#include <QColor>
#include <QImage>

#include <cstdint>
#include <vector>

namespace asperity {

/// A surface seen from above: in the colors of a quantity, and shaded as hills under light from the
/// upper left. The top of the image is the far side, large y.
/// Parts of the scan without data are hatched gray: heights there are filled in. The same holds
/// where a quantity of a part of the surface misses a value; beside that part it is plain gray. For
/// quantities that change with the tip the colors are those of heights.
class ReliefImage {
public:
    /// Creates an empty image.
    ReliefImage() = default;

    /// Samples the surface, at most 512 times along either side, and colors it as it did before.
    void setSurface(const BSplineSurface& surface);
    /// @param field the look's quantity on the surface
    void setLook(const SurfaceLook& look, const SurfaceField& field);

    [[nodiscard]] const QImage& image() const { return image_; }
    /// Heights of the pixels, top row first [m].
    [[nodiscard]] const std::vector<double>& heights() const { return heights_; }
    [[nodiscard]] const ColorScale& colors() const { return colors_; }
    /// Returns whether parts of the scan hold no data.
    [[nodiscard]] bool hasFilled() const { return hasFilled_; }
    /// Returns whether the quantity misses values in its part of the scan.
    [[nodiscard]] bool hasGaps() const { return field_.hasGaps(); }

private:
    [[nodiscard]] double xOf(int column) const;  ///< of a pixel's middle [m]
    [[nodiscard]] double yOf(int row) const;     ///< same
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
    std::vector<float> shades_;           ///< brightness of the pixels, 1 for a level surface
    std::vector<std::uint8_t> measured_;  ///< whether the scan holds data there
    ColorScale colors_;
    bool hasFilled_ = false;
};

/// Color of a pixel where the scan holds no data: gray stripes that run up to the right.
[[nodiscard]] QColor hatched(int row, int column);

/// A map seen from above, colored by height; gray stripes where it holds no data. The colors run
/// from the height that 0.5 % of the pixels lie below to the one that 0.5 % lie above, so that a
/// few outliers do not leave the rest in one color.
/// @return at most 512 pixels along either side, the map's top row at the top; any thread
[[nodiscard]] QImage heightPicture(const HeightMap& map);

}  // namespace asperity
