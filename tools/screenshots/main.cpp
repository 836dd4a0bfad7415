/// Opens the live window, approaches to the setpoint of the scene and retracts, and saves what the
/// window shows of the whole cycle: far, snapped in, at the setpoint, shortly before pull-off and
/// off. Usage: asperity_screenshots SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX

#include "tools/screenshots/CycleWindow.h"
#include "tools/screenshots/PictureTool.h"

namespace asperity {

namespace {

int run(char** argv) {
    CycleWindow cycle(argv);
    return cycle.run([&cycle](const std::string& moment) { cycle.save(moment); });
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 4,
                                    "asperity_screenshots SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX",
                                    asperity::run);
}
