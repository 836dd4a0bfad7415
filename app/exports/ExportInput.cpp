#include "app/exports/ExportInput.h"

#include "app/runs/LiveRun.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"

#include <utility>

namespace asperity {

std::string exportName(const std::filesystem::path& input) {
    const std::filesystem::path whole = std::filesystem::absolute(input).lexically_normal();
    const std::filesystem::path last =
        whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    return std::filesystem::is_directory(input) ? last.string() : last.stem().string();
}

ExportInput::ExportInput(const std::filesystem::path& input, Progress* progress) {
    if (!std::filesystem::is_directory(input)) {
        loaded_ = std::make_unique<const LoadedScene>(loadScene(input, {}, progress));
        return;
    }
    RunOnDisk run = readRunInputs(input);
    loaded_ =
        std::make_unique<const LoadedScene>(loadScene(input / run_files::kScene, {}, progress));
    if (loaded_->sha256 != run.sha256) {
        throw InputError(loaded_->scene.description.sample.file, "",
                         "the scan has changed since the run was recorded (its hash differs)");
    }
    note_ = sentenceOf(run.state);
    run_.emplace(loaded_->scene, std::move(run.inputs));
}

TickSample ExportInput::restingSample() const {
    const Vector3 start = startPlace(scene());
    TickSample first;
    runVirtually(scene(), DevicePath({{0.0, start}}), *instrumentOf(scene()), 1,
                 [&first](const TickSample& sample) { first = sample; });
    return first;
}

}  // namespace asperity
