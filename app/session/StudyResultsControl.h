#pragma once

#include "app/experiment/ExperimentFolder.h"
#include "app/session/LongWork.h"

#include <functional>

namespace asperity {

class StudyResultsDialog;

/// Writes the tables and figures of a study's folder in the background, and shows them.
class StudyResultsControl {
public:
    explicit StudyResultsControl(MainWindow& window);

    /// Has a function read the folder, which nobody writes to meanwhile. Any thread.
    using WithFolder =
        std::function<void(const std::function<void(const ExperimentFolder& folder)>& read)>;
    void show(const WithFolder& withFolder);
    /// Whether they are being drawn.
    [[nodiscard]] bool isBusy() const { return work_.isBusy(); }

private:
    struct Drawn {
        std::string folder;
        std::string text;
        std::vector<std::pair<std::string, std::string>> figures;  ///< name and file
    };

    void show(const Drawn& drawn);

    MainWindow& window_;
    StudyResultsDialog* dialog_ = nullptr;  ///< of the window; null: not shown yet
    LongWork<Drawn> work_;
};

}  // namespace asperity
