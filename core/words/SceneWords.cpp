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

std::vector<std::string> sceneNotes(const Scene& scene, const SceneNeeds& needs) {
    std::vector<std::string> notes;
    if (scene.shape) {
        notes.emplace_back("the sample is an exact shape, drawn by 256 x 256 heights");
    } else {
        notes = {levelingNote(scene), imagingTipNote(scene)};
    }
    notes.push_back(lawNote(scene));
    notes.push_back(modelNote(needs));
    return notes;
}

}  // namespace asperity
