#pragma once

#include "app/experiment/OpenStudy.h"
#include "app/session/LongWork.h"
#include "app/session/StudyResultsControl.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <optional>

namespace asperity {

class StudyForm;

/// Which study the form offers, for whom and in which folder, until it is opened.
class StudyChoice : public QObject {
    Q_OBJECT

public:
    /// @param form, results outlive this
    StudyChoice(MainWindow& window, StudyForm& form, StudyResultsControl& results);

    /// Reads what the form shows again: trials may have come.
    void show();
    void chooseStudy(const std::filesystem::path& file);
    void chooseFolder(const std::filesystem::path& folder);

Q_SIGNALS:
    void opened(std::shared_ptr<asperity::OpenStudy> study);

private:
    void open();
    void showResults();
    void showFolder();

    MainWindow& window_;
    StudyForm& form_;
    StudyResultsControl& results_;
    std::optional<Study> study_;  ///< none: it cannot be read
    std::filesystem::path file_;  ///< of the study
    std::filesystem::path folder_;
    LongWork<std::shared_ptr<OpenStudy>> work_;
};

}  // namespace asperity
