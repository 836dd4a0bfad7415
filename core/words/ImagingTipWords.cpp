#include "core/words/ImagingTipWords.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/scene/Scene.h"

#include <algorithm>

namespace asperity {

namespace {

std::string certainPercent(const Scene& scene) {
    return formatted("%.0f %%", 100.0 * scene.certainty.certainShare());
}

}  // namespace

std::string imagingTipNote(const Scene& scene) {
    if (scene.shape) {
        return "imaging tip: none, the sample is an exact shape that no tip recorded";
    }
    const SampleDescription& sample = scene.description.sample;
    if (sample.imagingTipRadius == 0.0) {
        return std::string("imaging tip: ") + kScanHoldsItsTip +
               "; [sample] imaging_tip_radius_m and erode take it out";
    }
    const std::string tip = "imaging tip of " + formatSi(sample.imagingTipRadius, "m");
    const BSplineSurface::Grid& grid = scene.surface.grid();
    if (sample.imagingTipRadius < std::min(grid.pitchX, grid.pitchY)) {
        return tip + ": narrower than a pixel, so that the scan shows nothing of its shape";
    }
    const std::string certain = certainPercent(scene) +
                                " of the pixels are certainly touched by it (elsewhere "
                                "the flag uncertain_pixel)";
    return sample.erode ? tip + ": its shape was taken out by erosion; " + certain
                        : tip + ": " + kScanHoldsItsTip + "; " + certain;
}

std::string imagingTipWords(const Scene& scene) {
    if (scene.shape) {
        return "Exact shape, no imaging tip";
    }
    const SampleDescription& sample = scene.description.sample;
    if (sample.imagingTipRadius == 0.0) {
        return "Holds the imaging tip's shape";
    }
    const std::string tip = formatSi(sample.imagingTipRadius, "m");
    return (sample.erode ? "Imaging tip of " + tip + " taken out, "
                         : "Holds the shape of a " + tip + " tip, ") +
           certainPercent(scene) + " certain";
}

}  // namespace asperity
