#include "core/words/SceneWords.h"

#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/scene/SampleHardness.h"
#include "core/scene/Scene.h"
#include "core/words/ImagingTipWords.h"
#include "core/words/LevelingWords.h"
#include "core/words/ModelWords.h"

#include <algorithm>
#include <filesystem>

namespace asperity {

namespace {

std::string cropWords(const PixelRectangle& crop) {
    return formatted("%d x %d pixels from column %d, row %d", crop.columns, crop.rows, crop.column,
                     crop.row);
}

/// Tenths without end zeros: "1", "1.2".
std::string pixelWords(double pixels) {
    return formatted("%.3g", pixels) + (pixels == 1.0 ? " pixel" : " pixels");
}

/// What no deviation of a result holds: docs/uncertainty.md 1.6.
std::string noisyWords(const Scene& scene) {
    // At 0.09 (30 pm and a low-pass of one pixel of 1 nm, a tip of 15 nm) readings lie within their
    // deviations, at 0.3 they are half of what they should be.
    constexpr double kNoisy = 0.15;  // of the tip's own curvature
    return scene.description.tip.radius * scene.curvatureNoise > kNoisy
               ? "; the tip touches the highest of noisy places first: pull-off and stiffness come "
                 "out too low, on ground blunter than the tip by more than their deviations say"
               : "";
}

}  // namespace

std::string smoothingNote(const Scene& scene) {
    const SampleDescription& sample = scene.description.sample;
    const std::string noise = formatSi(scene.heightNoise, "m") + " of height noise";
    const std::string tip = "a " + formatSi(scene.description.tip.radius, "m") + " tip";
    if (!scene.smoothing) {
        const double pixels = sample.smoothingPixels.value_or(0.0);
        const std::string width = sample.smoothingLength > 0.0
                                      ? formatSi(sample.smoothingLength, "m")
                                      : (pixels > 0.0 ? pixelWords(pixels) : "none");
        return "smoothing: " + width + ", as the scene states; " + noise + noisyWords(scene);
    }
    const auto& [pixels, isBounded] = *scene.smoothing;
    const std::string width = pixels > 0.0 ? pixelWords(pixels)
                              : isBounded  ? "none"
                                           : "none is needed";
    return "smoothing: " + width + ", by " + noise + " and " + tip +
           (isBounded ? "; more would take away the surface's own curvature" : "") +
           noisyWords(scene);
}

std::string sampleName(const SampleDescription& sample) {
    if (!sample.shape) {
        return printable(std::filesystem::path(sample.file).filename().string() + ", channel " +
                         sample.channel + (sample.crop ? ", " + cropWords(*sample.crop) : ""));
    }
    switch (sample.shape->kind) {
    case ShapeKind::Sphere:
        return "sphere of radius " + formatSi(sample.shape->radius, "m");
    case ShapeKind::Cylinder:
        return "cylinder of radius " + formatSi(sample.shape->radius, "m");
    case ShapeKind::Plane:
        break;
    }
    return "plane of slope " + formatSi(sample.shape->slope, "rad");
}

std::string hardnessText(const SampleMaterial& material) {
    const SampleHardness hardness = hardnessOf(material);
    switch (hardness.source) {
    case HardnessSource::Stated:
        return formatSi(hardness.value, "Pa");
    case HardnessSource::Estimated:
        return "not stated: estimated as " + formatSi(hardness.value, "Pa") +
               ", a twentieth of Young's modulus (within a factor of 4)";
    case HardnessSource::Unknown:
        return "not known: onset of yield is not looked for";
    case HardnessSource::DoesNotYield:
        break;
    }
    return "none: the sample does not yield";
}

std::vector<std::string> surfaceNotes(const Scene& scene) {
    if (scene.shape) {
        return {"the sample is an exact shape, drawn by 256 x 256 heights"};
    }
    std::vector<std::string> notes = levelingNotes(scene.removedBySteps);
    notes.push_back(smoothingNote(scene));
    notes.push_back(imagingTipNote(scene));
    const double pixel = std::max(scene.surface.grid().pitchX, scene.surface.grid().pitchY);
    if (pixel > kWidePixel * scene.description.tip.radius) {
        notes.push_back("pixels: " + formatSi(pixel, "m") + ", coarse for a " +
                        formatSi(scene.description.tip.radius, "m") +
                        " tip; what lies between them is in no number and no deviation");
    }
    if (const auto& crop = scene.description.sample.crop) {
        notes.insert(notes.begin(), "crop: " + cropWords(*crop) +
                                        " of the file are loaded; places count from their "
                                        "lower-left corner");
    }
    return notes;
}

std::vector<std::string> forceNotes(const Scene& scene, const SceneNeeds& needs) {
    std::vector<std::string> notes{lawNote(scene), modelNote(needs)};
    const SampleMaterial& material = scene.description.sample.material;
    if (hardnessOf(material).source == HardnessSource::Estimated) {
        notes.push_back("hardness: " + hardnessText(material));
    }
    return notes;
}

}  // namespace asperity
