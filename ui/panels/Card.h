#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>

class QHBoxLayout;
class QToolButton;
class QVBoxLayout;

namespace asperity {

/// The frame that all panels share: a title, a note at its right, and below them the panel's own.
class Card : public QFrame {
public:
    explicit Card(const QString& title, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const;
    /// From now on a click on the title folds the card: then it is as high as its title.
    void setFoldable();
    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return folded_; }

protected:
    /// Where the panel puts its contents.
    [[nodiscard]] QVBoxLayout& body() { return *body_; }
    /// A few words beside the title.
    void setNote(const QString& note) { note_->setText(note); }
    /// A control at the right of the title.
    void addToHeading(QWidget* control);

private:
    QToolButton* heading_;
    QHBoxLayout* top_;  ///< heading, note, controls
    QLabel* note_;
    QWidget* content_;  ///< below the heading
    QVBoxLayout* body_;
    bool folded_ = false;
};

/// What a number is: small and gray.
[[nodiscard]] QLabel* captionLabel(const QString& text, QWidget* parent = nullptr);

/// A number that changes often: plain text, right-aligned, of the constant size of `widest`, so
/// that nothing around it moves or is laid out anew.
[[nodiscard]] QLabel* valueLabel(const QString& objectName, const QString& widest,
                                 QWidget* parent = nullptr);

}  // namespace asperity
