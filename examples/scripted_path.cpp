// A tip that a script moves over a scene, as the model and the simulated AFM have it: scripted_path
// SCENE.toml or SCAN
#include "core/haptics/VirtualRun.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

void printForces(const char* file) {
    using namespace asperity;
    const Scene scene = sceneOnSample(sceneFromInput(file)).scene;
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    const DevicePath path = slidePath(scene, {.duration = 2.0, .slideLength = 20e-9});
    const long ticks = std::lround(2.0 / scene.timeStep());
    std::printf("time_s,base_z_m,model_n,estimate_n,flags\n");
    runVirtually(scene, path, afm, ticks, [](const TickSample& sample) {
        const TickOutput& out = sample.output;
        std::printf("%.3f,%.4e,%.4e,%.4e,%s\n", sample.time, out.base.position.z(),
                    out.model.force.z(), out.estimate.force.z(), validityText(out.flags).c_str());
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: scripted_path SCENE.toml or SCAN\n");
        return 2;
    }
    try {
        printForces(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
