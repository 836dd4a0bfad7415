#include "core/words/SceneWords.h"

#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/Scene.h"
#include "core/words/ModelWords.h"

#include <algorithm>
#include <cctype>
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

/// Not in any deviation of a result: docs/uncertainty.md 1.6.
std::string noisyWords(const Scene& scene) {
    // At 0.09 (30 pm and a low-pass of one pixel of 1 nm, a tip of 15 nm) readings lie within their
    // deviations, at 0.3 they are half of what they should be.
    constexpr double kNoisy = 0.15;  // of the tip's own curvature
    return scene.description.tip.radius * scene.curvatureNoise > kNoisy
               ? "; the tip touches the highest of noisy points first: pull-off and stiffness are "
                 "too low; on surfaces blunter than the tip by more than the stated deviations"
               : "";
}

std::string certainPercent(const Scene& scene) {
    return formatted("%.0f %%", 100.0 * scene.certainty.certainShare());
}

std::string slopesText(const PlaneFit& plane) {
    return formatted("slopes %+.4g along x and %+.4g along y", plane.slopeX, plane.slopeY);
}

std::string scarsText(std::size_t pixels) {
    return pixels == 0
               ? "no scars found"
               : std::to_string(pixels) + (pixels == 1 ? " pixel of scars" : " pixels of scars") +
                     " interpolated and marked as filled";
}

std::string sentenceOf(const RemovedByStep& removed) {
    switch (removed.step) {
    case LevelingStep::Plane:
        return "plane with " + slopesText(removed.plane) + " removed";
    case LevelingStep::Rows:
        return "the median of each row and the mean removed (medians spread by " +
               formatSi(removed.shiftSpread, "m") + ")";
    case LevelingStep::ThreePoint:
        return "plane through three points with " + slopesText(removed.plane) +
               " removed; they lie at height 0";
    case LevelingStep::Facet:
        return "plane of the prevailing facets with " + slopesText(removed.plane) +
               " and the mean removed";
    case LevelingStep::Quadratic:
        return "polynomial of second degree removed: " + slopesText(removed.plane) +
               formatted(" at the center, second derivatives %+.4g along x, %+.4g along y, %+.4g "
                         "mixed [1/m]",
                         removed.bendX, removed.bendY, removed.twist);
    case LevelingStep::MedianOfDifferences:
        return "rows shifted by the median of differences, trend along y kept (shifts spread by " +
               formatSi(removed.shiftSpread, "m") + ")";
    case LevelingStep::Scars:
        return scarsText(removed.pixels);
    case LevelingStep::Zero:
        return "lowest height, " + formatSi(removed.plane.mean, "m") + ", set to 0";
    }
    return keyOf(removed.step);
}

/// Prefix of a caption that other groups have, too.
std::string ownerOf(SceneGroup group) {
    switch (group) {
    case SceneGroup::Tip:
        return "Tip";
    case SceneGroup::Probe:
        return "Lever";
    case SceneGroup::Truth:
        return "True";
    case SceneGroup::Shape:
        return "Shape";
    case SceneGroup::Uncertainty:
        return "Deviation of";
    default:
        return {};
    }
}

/// "Young's modulus", "InvOLS" and "Q factor" keep their capital.
std::string within(const std::string& caption) {
    const bool isName = caption.find("'s ") != std::string::npos || caption.size() < 2 ||
                        std::isupper(static_cast<unsigned char>(caption[1])) != 0 ||
                        caption[1] == ' ' || caption.starts_with("InvOLS");
    std::string text = caption;
    if (!isName) {
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string valueText(const SceneField& field, const SceneValue& value) {
    if (const auto* const number = std::get_if<double>(&value)) {
        const std::string unit = field.words.unit;
        return formatted("%.6g", *number / field.words.scale) +
               (unit.empty() || unit == "°" ? unit : " " + unit);
    }
    if (const auto* const on = std::get_if<bool>(&value)) {
        return *on ? "on" : "off";
    }
    const std::string& text = std::get<std::string>(value);
    const auto choice = std::ranges::find(field.choices, text, &SceneChoice::key);
    return choice == field.choices.end() ? text : choice->name;
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
                                        " of the file are loaded; positions count from their "
                                        "lower-left corner");
    }
    return notes;
}

std::vector<std::string> forceNotes(const Scene& scene, const RequiredTerms& needs) {
    std::vector<std::string> notes{lawNote(scene), modelNote(needs)};
    const SampleMaterial& material = scene.description.sample.material;
    if (hardnessOf(material).source == HardnessSource::Estimated) {
        notes.push_back("hardness: " + hardnessText(material));
    }
    return notes;
}

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
    return sample.erode ? tip + ": its shape was removed by erosion; " + certain
                        : tip + ": " + kScanHoldsItsTip + "; " + certain;
}

std::string imagingTipWords(const Scene& scene) {
    if (scene.shape) {
        return "Exact shape, no imaging tip";
    }
    const SampleDescription& sample = scene.description.sample;
    if (sample.imagingTipRadius == 0.0) {
        return "Contains the imaging tip's shape";
    }
    const std::string tip = formatSi(sample.imagingTipRadius, "m");
    return (sample.erode ? "Imaging tip of " + tip + " removed, "
                         : "Contains the shape of a " + tip + " tip, ") +
           certainPercent(scene) + " certain";
}

std::vector<std::string> levelingNotes(const std::vector<RemovedByStep>& removed) {
    if (removed.empty()) {
        return {"leveling: none, heights as the file gives them"};
    }
    if (removed.size() == 1) {
        const bool isPlane = removed.front().step == LevelingStep::Plane;
        return {"leveling: " + sentenceOf(removed.front()) +
                (isPlane ? " (--level none keeps it)" : "")};
    }
    std::vector<std::string> notes;
    for (const RemovedByStep& one : removed) {
        notes.push_back(formatted("leveling, step %zu of %zu: ", notes.size() + 1, removed.size()) +
                        sentenceOf(one));
    }
    return notes;
}

std::string valueText(const SceneField& field, const SceneDescription& scene) {
    return valueText(field, field.get(scene));
}

std::string changeText(const SceneField& field, const SceneDescription& scene) {
    const std::string owner = ownerOf(field.group);
    const std::string caption = field.words.caption;
    const bool isAlone = owner.empty() || owner == caption;
    return (isAlone ? caption : owner + " " + within(caption)) + ": " + valueText(field, scene);
}

}  // namespace asperity
