#pragma once

#include <QTimer>
#include <QToolButton>

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
    [[nodiscard]] bool isOnArrow(const QPoint& place) const;

    QTimer secondClick_;  ///< runs while one may follow
    bool pressedArrow_ = false;
};

}  // namespace asperity
