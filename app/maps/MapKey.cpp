#include "app/maps/MapKey.h"

#include "app/program/ProgramParts.h"
#include "core/io/FileHash.h"
#include "core/io/TextValue.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SceneFiles.h"

namespace asperity {

namespace {

std::string textOf(const MapPlan& plan) {
    std::string text = std::string(keyOf(plan.mode)) + (plan.truth ? " truth" : " belief");
    for (const double value : {plan.region.left, plan.region.bottom, plan.region.right,
                               plan.region.top, plan.setpoint}) {
        text += " " + exactText(value);
    }
    text += " " + std::to_string(plan.grid.columns) + " " + std::to_string(plan.grid.rows);
    for (const MapQuantity quantity : plan.quantities) {
        text += " " + std::string(keyOf(quantity));
    }
    return text;
}

}  // namespace

std::string mapKey(const LoadedScene& loaded, const MapPlan& plan) {
    SceneDescription scene = settled(loaded.scene.description, loaded.scene.model);
    forEachFile(scene, [](std::string& file) { file.clear(); });  // contents count, not places
    Sha256 hash;
    for (const std::string& part :
         {versionWithCommit(), loaded.sha256, sceneText(scene), textOf(plan)}) {
        hash.add(part + "\n");
    }
    return hash.digits();
}

}  // namespace asperity
