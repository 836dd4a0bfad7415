#pragma once

#include "app/session/LibraryControl.h"

namespace asperity {

/// The materials that a sample can be, in the bar above the views and in the scene panel.
class MaterialControl : public LibraryControl {
    Q_OBJECT

public:
    MaterialControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

private:
    [[nodiscard]] SceneDescription read(const std::filesystem::path& file) const override;
    [[nodiscard]] QString nameOf(const SceneDescription& scene,
                                 const std::filesystem::path& file) const override;
    [[nodiscard]] bool isSame(const SceneDescription& a, const SceneDescription& b) const override;
    [[nodiscard]] SceneDescription with(const SceneDescription& scene,
                                        const SceneDescription& item) const override;
    [[nodiscard]] SceneDescription renamed(SceneDescription scene,
                                           const std::string& name) const override;
    [[nodiscard]] std::string textOf(const SceneDescription& scene,
                                     const std::string& notes) const override;
    void listed(const QStringList& names, int present) override;

    MainWindow& shown_;
};

}  // namespace asperity
