#include "tests/hardware/woodenhaptics/CoupledTip.h"

#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "tests/support/TestScenes.h"

namespace asperity::test {

namespace {

Scene coupledScene() {
    SceneDescription description = plainScene();
    description.settings.positionGain = 1.0_nm / 1e-3;
    description.settings.forceGain = 1.0 / 10.0_nN;
    description.settings.coupling = {.stiffness = 600.0, .damping = 2.9, .proxyDamping = 3.0};
    Scene scene = buildScene(description, flatMap());
    scene.settings.governor.engageTime = 10e-3;  // shorter than an operator may have it
    return scene;
}

}  // namespace

Vector3 handleAt(double height) { return {64e-3, 64e-3, height}; }

CoupledTip::CoupledTip(HapticDevice& device)
    : scene_(coupledScene())
    , afm_(scene_.trueSurface(), truthOf(scene_))
    , settings_(scene_.settings)
    , loop(scene_, device, afm_) {}

void CoupledTip::resetFault() {
    if (now().output.fault != Fault::None) {
        ++settings_.rearms;
        loop.setSettings(settings_);
    }
}

}  // namespace asperity::test
