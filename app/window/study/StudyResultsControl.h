#pragma once

#include "app/experiment/ExperimentFolder.h"
#include "app/window/LongWork.h"

#include <QDialog>
#include <QPixmap>

#include <functional>
#include <vector>

class QLabel;
class QPlainTextEdit;
class QTabWidget;

namespace asperity {

class StudyResultsDialog;

/// Writes the tables and figures of a study's folder in the background, and shows them.
class StudyResultsControl {
public:
    explicit StudyResultsControl(Host& host);

    /// Has a function read the folder; nobody else writes to it. Any thread.
    using WithFolder =
        std::function<void(const std::function<void(const ExperimentFolder& folder)>& read)>;
    void show(const WithFolder& withFolder);
    [[nodiscard]] bool isBusy() const { return work_.isBusy(); }

private:
    struct Drawn {
        std::string folder;
        std::string text;
        std::vector<std::pair<std::string, std::string>> figures;  ///< name and file
    };

    void show(const Drawn& drawn);

    Host& host_;
    StudyResultsDialog* dialog_ = nullptr;  ///< of the window; null: not shown yet
    LongWork<Drawn> work_;
};

/// A figure of a study, and what it is called.
struct StudyFigure {
    QString name;
    QPixmap picture;
};

/// Results of a study so far: its figures, and its means and findings as text. The window stays
/// responsive.
class StudyResultsDialog : public QDialog {
    Q_OBJECT

public:
    explicit StudyResultsDialog(QWidget* window);

    /// @param folder in which all of it lies
    void showResults(const QString& folder, const QString& text,
                     const std::vector<StudyFigure>& figures);

private:
    QLabel* folder_;
    QTabWidget* tabs_;
};

}  // namespace asperity
