#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <cstdint>
#include <vector>

namespace asperity {

/// The surface under a scan, as far as the scan shows it, for a spherical tip of known radius.
///
/// A scan is the surface dilated by the tip's shape: image(x) = max over d of surface(x + d) -
/// rise(d), with rise(d) = R - sqrt(R^2 - d^2) for d <= R, the tip's surface above its apex. The
/// erosion surface(x) <= min over d of image(x + d) + rise(d) is the highest surface that would
/// have given the same image. All on the pixel grid; the tip's axis is z. Source: Villarrubia
/// (1997), J. Res. NIST 102, 425; docs/surface.md.
///
/// Between pixels the touched point is the bottom of the paraboloid through the lowest sum and its
/// eight neighbors. Where slopes and curvatures count it has to be: from pixel to pixel it goes in
/// steps, between which the erosion has the image's own curvature.
///
/// A pixel that is marked invalid, or whose height is not a finite number, takes no part and stays
/// what it is. Nothing lies beyond the map's borders. Linear time in the pixels, and few times a
/// block of pixels for each, however wide the tip, on the surfaces of scans.

/// Heights are stored in the map's own precision and computed with in double.

/// The image that a tip of this radius would record of the surface.
/// @throw Error when the map is unusable or the radius is not a positive length
[[nodiscard]] HeightMap dilated(HeightMap surface, double tipRadius);

/// The reconstruction from an image that a tip of this radius recorded; nowhere above the image.
/// @throw Error as dilated()
[[nodiscard]] HeightMap eroded(HeightMap image, double tipRadius);

/// Points at which a tip may have touched.
enum class TouchedPoint : std::uint8_t {
    Pixel,          ///< at pixel centers alone: the erosion by its definition
    BetweenPixels,  ///< between them, too
};

/// An eroded map with what is certain about it.
template <class Map>
struct BasicTipReconstruction {
    Map surface;
    /// rows x columns, 1 where the tip must have touched the surface: the reconstruction is it.
    /// Elsewhere it is an upper bound.
    std::vector<std::uint8_t> certain;
};
using TipReconstruction = BasicTipReconstruction<HeightMap>;
/// Reconstruction of a large scan: beside the image only its surface and the certainty are in
/// memory.
using ScanReconstruction = BasicTipReconstruction<ScanMap>;

/// As eroded(), with the certainty map: a pixel is certain where, for some position of the tip, it
/// is the only one that the tip can have touched; there the reconstruction is the surface of the
/// pixel grid, to rounding. A height that the map's precision cannot tell from a touching one
/// counts as touching. Positions where the tip reaches beyond the map's edges, or where it can have
/// touched below an invalid pixel, prove nothing.
/// @param point of the surface; what is certain is a matter of the pixels
/// @throw Error as dilated(); Canceled
[[nodiscard]] TipReconstruction reconstructed(HeightMap image, double tipRadius,
                                              Progress* progress = nullptr,
                                              TouchedPoint point = TouchedPoint::Pixel);
[[nodiscard]] ScanReconstruction reconstructed(ScanMap image, double tipRadius,
                                               Progress* progress = nullptr,
                                               TouchedPoint point = TouchedPoint::Pixel);

/// The certainty map alone.
/// @throw Error as dilated(); Canceled
[[nodiscard]] std::vector<std::uint8_t> certainPixels(const HeightMap& image, double tipRadius,
                                                      Progress* progress = nullptr);
[[nodiscard]] std::vector<std::uint8_t> certainPixels(const ScanMap& image, double tipRadius,
                                                      Progress* progress = nullptr);

/// The pixels of a scan that the tip which recorded it has certainly touched: there the scan proves
/// the height of the surface; see TipErosion.h. Immutable, safe to read from any thread.
class CertaintyMap {
public:
    /// Creates the map of a scan whose tip is not known: nothing can be said to be uncertain.
    CertaintyMap() = default;
    /// @param map of the same pixels
    /// @param certain rows x columns, 1 where certain; row 0 is the top row
    template <class Heights>
    CertaintyMap(const BasicHeightMap<Heights>& map, const std::vector<std::uint8_t>& certain)
        : columns_(map.columns)
        , rows_(map.rows)
        , pitchX_(map.pitchX)
        , pitchY_(map.pitchY)
        , certain_(certain.begin(), certain.end()) {}

    [[nodiscard]] bool isKnown() const noexcept { return !certain_.empty(); }
    /// Returns whether the imaging tip did not certainly touch the pixel at world (x, y) [m]; a
    /// position outside the scan counts as the nearest one inside.
    [[nodiscard]] bool isUncertain(double x, double y) const noexcept;
    /// Part of all pixels that is certain.
    [[nodiscard]] double certainShare() const noexcept;

private:
    int columns_ = 0;
    int rows_ = 0;
    double pitchX_ = 0.0;  ///< [m]
    double pitchY_ = 0.0;  ///< [m]
    PixelMask certain_;
};

}  // namespace asperity
