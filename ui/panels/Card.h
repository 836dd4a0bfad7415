#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>

class QHBoxLayout;
class QVBoxLayout;

namespace asperity {

/// The frame that all panels share: a title, a note at its right, and below them the panel's own.
class Card : public QFrame {
public:
    explicit Card(const QString& title, QWidget* parent = nullptr);

protected:
    /// Where the panel puts its contents.
    [[nodiscard]] QVBoxLayout& body() { return *body_; }
    /// A few words beside the title.
    void setNote(const QString& note) { note_->setText(note); }
    /// A control at the right of the title.
    void addToHeading(QWidget* control);

private:
    QVBoxLayout* body_;
    QHBoxLayout* heading_;
    QLabel* note_;
};

/// What a number is: small and gray.
[[nodiscard]] QLabel* captionLabel(const QString& text, QWidget* parent = nullptr);

/// A number that changes often: plain text, right-aligned, of the constant size of `widest`, so
/// that nothing around it moves or is laid out anew.
[[nodiscard]] QLabel* valueLabel(const QString& objectName, const QString& widest,
                                 QWidget* parent = nullptr);

}  // namespace asperity
