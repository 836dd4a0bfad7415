#include "app/recording/Recording.h"

#include "app/recording/RecordingManifest.h"
#include "app/recording/RunPacking.h"
#include "app/runs/RunSummary.h"
#include "core/GrowingFile.h"
#include "core/io/recording/TickMemoryFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"

#include <utility>

namespace asperity {

namespace {

RecordingManifest manifestOf(const LoadedScene& loaded) {
    const BSplineSurface& surface = loaded.scene.surface;
    return {.sha256 = loaded.sha256, .size = Vector2(surface.sizeX(), surface.sizeY())};
}

}  // namespace

// The manifest comes last: where it is, all is there that a replay takes.
Recording::Recording(const RecordingPlace& place, const LoadedScene& loaded,
                     const TickMemory& memory, double delay)
    : begin_(place.folder, place.replace)
    , loaded_(loaded)
    , format_(place.format)
    , recorder_(folder(), loaded.scene.belief.field)
    , energy_(folder() / run_files::kEnergy, loaded.scene.timeStep(), delay) {
    writeTickMemory(folder() / run_files::kMemory, memory);
    writeScene(loaded.scene.settings);
    flush();
    writeManifest(folder(), manifestOf(loaded));
    if (place.replace) {
        sync();  // the earlier run goes: a power cut must not take both
    }
    begin_.keep();
}

void Recording::writeScene(const Settings& start) {
    start_ = start;
    SceneDescription scene = settled(loaded_.scene.description, loaded_.scene.model);
    scene.settings = start;
    writeTextFile(folder() / run_files::kScene, sceneText(scene));
}

void Recording::take(const TickSample& sample) {
    if (ticks() == 0) {
        if (sample.input.settings != start_) {
            writeScene(sample.input.settings);
        }
    } else {
        const double gap = sample.time - lastTime_ - sample.input.timeStep;
        broken_ = broken_ || gap > 0.5 * loaded_.scene.timeStep();
    }
    if (!broken_) {
        recorder_.take(sample);
        events_.take(sample);
        energy_.take(sample);
        lastTime_ = sample.time;
    }
}

void Recording::flush() {
    recorder_.flush();
    energy_.flush();
}

void Recording::sync() {
    if (!std::exchange(startSynced_, true)) {
        for (const char* name :
             {run_files::kMemory, run_files::kScene, run_files::kManifest, "."}) {
            syncToDisk(folder() / name);
        }
    }
    recorder_.sync();
    energy_.sync();
}

void Recording::finish() {
    flush();
    writeTextFile(folder() / run_files::kSummary, runSummary(loaded_, events_.events()));
    syncToDisk(folder() / run_files::kSummary);
    sync();
    RecordingManifest manifest = manifestOf(loaded_);
    manifest.complete = true;
    writeManifest(folder(), manifest);
    if (format_ == RunFormat::Hdf5 && ticks() > 0) {
        packRun(folder());
    }
}

}  // namespace asperity
