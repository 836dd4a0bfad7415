#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"

#include <filesystem>
#include <functional>
#include <string>

namespace asperity {

/// Writes the page of `asperity report` on a recording: the one that is looked at, else one that
/// the user chooses.
class ReportControl : public Feature {
    Q_OBJECT

public:
    explicit ReportControl(Stage& stage);

    /// Writes the page in the background, then opens it; says in the window why that fails.
    /// @param run its folder, a file in it, or a bundle @param folder for the page
    void write(const std::filesystem::path& run, const std::filesystem::path& folder);

Q_SIGNALS:
    /// @param page that was written and opened
    void written(QString page);

private:
    void ask();

    LongWork<std::filesystem::path> work_;
};

}  // namespace asperity
