#include "core/words/SceneWords.h"

#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/words/ImagingTipWords.h"
#include "core/words/ModelWords.h"

#include <filesystem>

namespace asperity {

namespace {

std::string levelingNote(const Scene& scene) {
    switch (scene.description.sample.leveling) {
    case Leveling::None:
        return "leveling: none, heights as the file gives them";
    case Leveling::Rows:
        return "leveling: the median of each row and the mean removed";
    case Leveling::Plane:
        break;
    }
    return formatted("leveling: plane with slopes %+.4g along x and %+.4g along y removed "
                     "(--level none keeps it)",
                     scene.removedPlane.slopeX, scene.removedPlane.slopeY);
}

}  // namespace

std::string sampleName(const SampleDescription& sample) {
    if (!sample.shape) {
        return printable(std::filesystem::path(sample.file).filename().string() + ", channel " +
                         sample.channel);
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

std::vector<std::string> surfaceNotes(const Scene& scene) {
    if (scene.shape) {
        return {"the sample is an exact shape, drawn by 256 x 256 heights"};
    }
    return {levelingNote(scene), imagingTipNote(scene)};
}

std::vector<std::string> forceNotes(const Scene& scene, const SceneNeeds& needs) {
    return {lawNote(scene), modelNote(needs)};
}

}  // namespace asperity
