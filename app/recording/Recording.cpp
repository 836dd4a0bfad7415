#include "app/recording/Recording.h"

#include "app/recording/RecordingRecovery.h"
#include "app/recording/RunPacking.h"
#include "core/GrowingFile.h"
#include "core/Version.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/TickLog.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"

#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// The columns of energy_log.csv.
template <class Cell>
void listEnergy(double time, const PassivityObserver& observer, const Cell& cell) {
    cell({"time_s"}, time);
    cell({"energy_j"}, observer.energy());
    cell({"spring_j"}, observer.spring());
}

}  // namespace

EnergyLog::EnergyLog(std::filesystem::path path, double timeStep, double delay)
    : path_(std::move(path)), watch_(timeStep, delay) {}

void EnergyLog::take(const TickSample& sample) {
    watch_.take(sample);
    const PassivityObserver* const observer = watch_.observer();
    if (observer == nullptr) {
        return;
    }
    const auto list = [&](const auto& cell) { listEnergy(sample.time, *observer, cell); };
    if (!csv_) {
        csv_.emplace(
            GrowingFile(path_),
            std::vector<std::string>{
                std::string("Asperity ") + kVersion + ": energy at the device; docs/haptics.md",
                "energy_j: from the device into the coupling, minus that stored in its spring and "
                "that leaked away; below -0.01 the coupling supplies energy of its own",
                "spring_j: stored by the coupling's spring for the force that acts at the handle"},
            columnNames(list));
    }
    addCells(*csv_, list);
    csv_->endRow();
}

void EnergyLog::flush() {
    if (csv_) {
        csv_->flush();
    }
}

void EnergyLog::sync() const {
    if (csv_) {
        csv_->sync();
    }
}

namespace {

RecordingManifest manifestOf(const LoadedScene& loaded) {
    const BSplineSurface& surface = loaded.scene.surface;
    return {.sha256 = loaded.sha256, .size = Vector2(surface.sizeX(), surface.sizeY())};
}

}  // namespace

// The manifest comes last: where it is, all is there that a replay needs.
Recording::Recording(const RecordingTarget& target, const LoadedScene& loaded,
                     const TickMemory& memory, double delay)
    : begin_(target.folder, target.replace)
    , loaded_(loaded)
    , format_(target.format)
    , recorder_(folder(), loaded.scene.belief.field)
    , energy_(folder() / run_files::kEnergy, loaded.scene.timeStep(), delay) {
    writeTickMemory(folder() / run_files::kMemory, memory);
    writeScene(loaded.scene.settings);
    flush();
    writeManifest(folder(), manifestOf(loaded));
    if (target.replace) {
        sync();  // the earlier run is deleted: a power cut must not take both
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
