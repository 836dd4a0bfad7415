#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RunPlayback.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// By which names of files are made: of a file without its extension, of a run its folder's.
[[nodiscard]] std::string exportName(const std::filesystem::path& input);

/// Whether it is the folder of a run, or a bundle of one.
[[nodiscard]] bool holdsRun(const std::filesystem::path& input);

/// What is exported: a scene, and where there is one, its run.
class ExportInput {
public:
    /// @param input scene.toml, a height map, the folder of a run or a bundle
    /// @throw InputError where it cannot be read, or the scan has changed since the run; Canceled
    explicit ExportInput(const std::filesystem::path& input, Progress* progress = nullptr);

    [[nodiscard]] const LoadedScene& loaded() const { return *loaded_; }
    [[nodiscard]] const Scene& scene() const { return loaded_->scene; }
    /// Null: there is none.
    [[nodiscard]] RunPlayback* run() { return run_ ? &*run_ : nullptr; }
    /// What there is to know about a run that is not complete; empty: it is.
    [[nodiscard]] const std::string& note() const { return note_; }
    /// The surface at rest with the tip where the window starts with it.
    [[nodiscard]] TickSample restingSample() const;

private:
    std::string note_;
    std::unique_ptr<const LoadedScene> loaded_;
    std::optional<RunPlayback> run_;
};

}  // namespace asperity
