#pragma once

#include <QDialog>
#include <QPixmap>

#include <vector>

class QLabel;
class QPlainTextEdit;
class QTabWidget;

namespace asperity {

/// A figure of a study, and what it is called.
struct StudyFigure {
    QString name;
    QPixmap picture;
};

/// What a study says so far: its figures, and its means and findings as text. The window goes on
/// beside it.
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
