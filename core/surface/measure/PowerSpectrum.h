#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <vector>

namespace asperity {

/// Waves of about one spatial frequency, in all directions.
struct SpectrumRing {
    double frequency = 0.0;  ///< mean over the waves [1/m]
    double density = 0.0;    ///< power spectral density, mean over the waves [m^4]
    double waves = 0.0;      ///< how many; each stands for the same area of frequencies
};

/// Areal power spectral density of heights, averaged over directions. Densities are two-sided:
/// summed over all waves, times the area of frequencies of one, they are Sq^2.
struct PowerSpectrum {
    /// By rising frequency, as far apart as the inverse of the longer side, up to the shortest wave
    /// along a diagonal. Empty where all heights are the same.
    std::vector<SpectrumRing> rings;
    double waveArea = 0.0;  ///< area of frequencies that each wave stands for [1/m^2]
};

/// The spectrum of a rectangle. Heights are about their mean under a Hann window along both axes,
/// which keeps its edges from adding power; their power is scaled so that Sq is that of the heights
/// without window. Pixels without data have no weight; many of them blur the spectrum.
/// Source: ISO 25178-2; Jacobs, Junge, Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001.
/// @throw Error when the rectangle reaches out of the map or none of its pixels holds data;
/// Canceled
[[nodiscard]] PowerSpectrum powerSpectrumOf(const HeightRows& map, const PixelRectangle& pixels,
                                            Progress* progress = nullptr);

}  // namespace asperity
