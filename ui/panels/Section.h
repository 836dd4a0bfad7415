#pragma once

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace asperity {

/// A part of a long page: a title that folds it, and below it rows of captions and controls.
class Section : public QWidget {
    Q_OBJECT

public:
    /// @param about what is in it, for the tool tip of the title
    Section(const QString& title, const QString& about, QWidget* parent = nullptr);

    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return folded_; }
    /// Where the rows go: captions in column 0, controls in column 1, buttons in column 2.
    [[nodiscard]] QGridLayout& rows() { return *rows_; }
    /// A widget over all columns, below the rows so far.
    void addWide(QWidget* widget);
    /// Disables the rows. @param reason that their tool tips say; empty: they work
    void refuse(const QString& reason);

private:
    QString about_;
    QString refusal_;  ///< as it is shown
    QToolButton* heading_;
    QWidget* content_;
    QGridLayout* rows_;
    bool folded_ = false;
};

}  // namespace asperity
