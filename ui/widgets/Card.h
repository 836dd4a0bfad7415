#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

class QHBoxLayout;
class QVBoxLayout;
class QGridLayout;
class QToolButton;

namespace asperity {

/// The title of a card that can be folded and enlarged. A click on the arrow folds at once; one on
/// the words folds when no second click follows, so that a double click only enlarges.
class CardHeading : public QToolButton {
    Q_OBJECT

public:
    explicit CardHeading(const QString& title, QWidget* parent = nullptr);

    /// From now on clicks do something; before that the title is mere text.
    void setActive();
    /// Shows by the arrow and the tool tip what a click does.
    void setState(bool folded, bool enlarged);

Q_SIGNALS:
    void foldRequested();
    void enlargeRequested();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    void take();
    [[nodiscard]] bool isOnArrow(const QPoint& point) const;

    QTimer secondClick_;  ///< runs while one may follow
    bool pressedArrow_ = false;
};

/// The frame that all panels share: a title, a note at its right, and below them the panel's own.
class Card : public QFrame {
    Q_OBJECT

public:
    explicit Card(const QString& title, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const;
    /// From now on a click on the title folds the card: then it is as high as its title. A double
    /// click asks for it to be enlarged.
    void setFoldable();
    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return folded_; }
    /// Sets whether the card has the middle of the window for itself; then it cannot be folded.
    void setEnlarged(bool enlarged);

    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void foldedChanged(bool folded);
    void enlargeRequested();

protected:
    /// Returns the layout for the contents of the panel.
    [[nodiscard]] QVBoxLayout& body() { return *body_; }
    /// A few words beside the title.
    void setNote(const QString& note) { note_->setText(note); }
    /// A control at the right of the title.
    void addToHeading(QWidget* control);
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    CardHeading* heading_;
    QHBoxLayout* top_;  ///< heading, note, controls
    QLabel* note_;
    QWidget* content_;  ///< below the heading
    QVBoxLayout* body_;
    bool foldable_ = false;
    bool folded_ = false;
    bool enlarged_ = false;
};

/// Makes the caption of a number: small and gray.
[[nodiscard]] QLabel* captionLabel(const QString& text, QWidget* parent = nullptr);

/// A number that changes often: plain text, right-aligned, of the constant size of `widest`, so
/// that nothing around it moves or is laid out again.
[[nodiscard]] QLabel* valueLabel(const QString& objectName, const QString& widest,
                                 QWidget* parent = nullptr);

/// A part of a long page: a title that folds it, and below it rows of captions and controls.
class Section : public QWidget {
    Q_OBJECT

public:
    /// @param about what is in it, for the tool tip of the title
    Section(const QString& title, const QString& about, QWidget* parent = nullptr);

    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return folded_; }
    /// Returns the grid: captions in column 0, controls in column 1, buttons in column 2.
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
