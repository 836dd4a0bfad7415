#include "core/io/recording/SceneSettings.h"

namespace asperity {

SceneDescription withSettings(SceneDescription scene, const Settings& settings) {
    scene.positionGain = settings.positionGain;
    scene.forceGain = settings.forceGain;
    scene.correctionBandwidth = settings.correctionBandwidth;
    scene.positionControl = settings.positionControl;
    scene.coupling = settings.coupling;
    scene.governor = settings.governor;
    scene.clutchButton = settings.clutchButton;
    scene.guide = settings.guide;
    return scene;
}

void checkSettings(const Settings& settings) { checkScene(withSettings(defaultScene(), settings)); }

}  // namespace asperity
