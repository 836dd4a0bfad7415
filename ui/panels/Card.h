#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>

class QHBoxLayout;
class QVBoxLayout;

namespace asperity {

class CardHeading;

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
    /// Tells whether the card has the middle of the window for itself; then it cannot be folded.
    void setEnlarged(bool enlarged);

    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void foldedChanged(bool folded);
    void enlargeRequested();

protected:
    /// Where the panel puts its contents.
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

/// What a number is: small and gray.
[[nodiscard]] QLabel* captionLabel(const QString& text, QWidget* parent = nullptr);

/// A number that changes often: plain text, right-aligned, of the constant size of `widest`, so
/// that nothing around it moves or is laid out anew.
[[nodiscard]] QLabel* valueLabel(const QString& objectName, const QString& widest,
                                 QWidget* parent = nullptr);

}  // namespace asperity
