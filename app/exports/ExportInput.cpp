#include "app/exports/ExportInput.h"

#include "app/loading/RunWithScene.h"
#include "app/loading/SceneLoader.h"
#include "app/recording/Bundle.h"
#include "app/recording/RunPlace.h"
#include "app/runs/LiveRun.h"

#include <utility>

namespace asperity {

std::string exportName(const std::filesystem::path& input) {
    const std::filesystem::path whole = std::filesystem::absolute(input).lexically_normal();
    const std::filesystem::path last =
        whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    return std::filesystem::is_directory(input) ? last.string() : last.stem().string();
}

bool holdsRun(const std::filesystem::path& input) {
    return std::filesystem::is_directory(input) || isBundle(input);
}

ExportInput::ExportInput(const std::filesystem::path& input, Progress* progress) {
    if (!holdsRun(input)) {
        loaded_ = std::make_unique<const LoadedScene>(loadScene(input, {}, progress));
        return;
    }
    const RunPlace place(input);
    RunWithScene read = place.read([&] { return readRunWithScene(place.folder(), progress); });
    loaded_ = std::make_unique<const LoadedScene>(std::move(read.loaded));
    note_ = std::move(read.note);
    run_.emplace(loaded_->scene, std::move(read.run.inputs));
}

TickSample ExportInput::restingSample() const {
    const Vector3 start = startPlace(scene());
    TickSample first;
    runVirtually(scene(), DevicePath({{0.0, start}}), *instrumentOf(scene()), 1,
                 [&first](const TickSample& sample) { first = sample; });
    return first;
}

}  // namespace asperity
