#pragma once

#include "app/experiment/OpenStudy.h"
#include "app/window/LongWork.h"
#include "app/window/study/StudyResultsControl.h"

#include <QObject>
#include <QWidget>

#include <filesystem>
#include <memory>
#include <optional>

class QLabel;
class QPushButton;
class QSpinBox;

namespace asperity {

/// Form for the study to be done, its participant and the folder of its results. Setters show a
/// state and emit nothing.
class StudyForm : public QWidget {
    Q_OBJECT

public:
    explicit StudyForm(QWidget* parent = nullptr);

    /// @param about what the study has, a few words
    void showStudy(const QString& name, const QString& about);
    /// @param state what is in the folder already
    void showFolder(const QString& folder, const QString& state);
    void showParticipant(int participant);
    [[nodiscard]] int participant() const;
    /// Shows why it cannot be started; empty: it can.
    void refuse(const QString& why);

Q_SIGNALS:
    void shown();
    void studyChosen(const QString& file);
    void folderChosen(const QString& folder);
    void startChosen();
    void resultsChosen();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void askForStudy();
    void askForFolder();

    QLabel* name_;
    QLabel* about_;
    QLabel* folder_;
    QLabel* state_;
    QSpinBox* participant_;
    QPushButton* start_;
    QPushButton* results_;
};

/// Choice of study, participant and folder, until the study is opened.
class StudyChoice : public QObject {
    Q_OBJECT

public:
    /// @param form, results outlive this
    StudyChoice(Host& host, StudyForm& form, StudyResultsControl& results);

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

    Host& host_;
    StudyForm& form_;
    StudyResultsControl& results_;
    std::optional<Study> study_;  ///< none: it cannot be read
    std::filesystem::path file_;  ///< of the study
    std::filesystem::path folder_;
    LongWork<std::shared_ptr<OpenStudy>> work_;
};

}  // namespace asperity
