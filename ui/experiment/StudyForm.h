#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QSpinBox;

namespace asperity {

/// Which study is to be done, by whom, and where its results go. Setters show a state and emit
/// nothing.
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
    /// Why it cannot be started; empty: it can.
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

}  // namespace asperity
