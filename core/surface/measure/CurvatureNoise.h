#pragma once

#include "core/surface/HeightMap.h"
#include "core/surface/fit/GaussianFilter.h"

#include <vector>

namespace asperity {

/// Standard deviation of the white noise in a scan's heights [m], from its highest frequencies: the
/// median of fourth differences along both axes, which leave of a smooth surface next to nothing
/// and of a step a few pixels. Noise that a feedback loop has filtered is larger than this. 0 where
/// the scan has fewer than 5 pixels along an axis, or no 5 x 5 pixels that all hold data. Of a
/// large scan some 65,000 positions count. Source: Immerkaer, Computer Vision and Image
/// Understanding 64 (1996) 300, with a higher order and the median; docs/uncertainty.md.
[[nodiscard]] double heightNoise(const HeightMap& map);
[[nodiscard]] double heightNoise(const ScanMap& map);

/// Noise in a scan's mean curvature, (z_xx + z_yy) / 2 of the fitted surface at a pixel's center,
/// after a low-pass, as its heights show it. Of a large scan 16 parts of 64 x 64 pixels count.
///
/// Noise of a scan is white from one line to the next, and along a line what the feedback loop has
/// made of it. Fourth differences across the lines show it, and with it what they leave of the
/// surface; those along the lines show that part of the surface alone, as the surface prefers no
/// direction. A scan's lines are its rows. Source: docs/uncertainty.md 1.2.
class CurvatureNoise {
public:
    /// @param map a HeightMap or a ScanMap
    /// @param heightNoise standard deviation of white noise that is known [m]; 0: not known
    template <class Map>
    explicit CurvatureNoise(const Map& map, double heightNoise = 0.0);

    /// Returns the standard deviation of the mean curvature by noise [1/m].
    [[nodiscard]] double noise(const Smoothing& smoothing) const;

    /// Returns what the low-pass takes from the mean curvature, to first order [1/m]: what another
    /// one of the same width changes in the median, without what noise changes.
    /// @param noise what noise() returns for it
    [[nodiscard]] double blur(const Smoothing& smoothing, double noise) const;

    /// Returns the standard deviation of the white noise of heights that would leave this noise
    /// [m].
    /// @param noise what noise() returns for it
    [[nodiscard]] double heightNoise(const Smoothing& smoothing, double noise) const;

private:
    /// A part of the scan, without holes.
    struct Part {
        int rows = 0;
        int columns = 0;
        std::vector<double> heights;  ///< row by row [m]
        PixelMask invalid;            ///< empty: none
    };

    /// Median over the parts of what fourth differences along one axis hold, as a variance of the
    /// mean curvature [1/m^2].
    [[nodiscard]] double differencesNoise(const Smoothing& smoothing, bool acrossRows) const;

    double pitchX_ = 0.0;
    double pitchY_ = 0.0;
    double white_ = 0.0;  ///< [m]
    bool isKnown_ = false;
    std::vector<Part> parts_;
};

}  // namespace asperity
