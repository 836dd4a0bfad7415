#pragma once

#include <QString>
#include <QWidget>

class QLabel;

namespace asperity {

class NumberBox;

/// The line below a plot for a measured curve that is drawn in it: name, offset along the distance
/// axis, a button that takes it away. Hidden while there is none.
class MeasuredBar : public QWidget {
    Q_OBJECT

public:
    explicit MeasuredBar(QWidget* parent = nullptr);

    /// Shows a curve with no offset; an empty name: there is none.
    void setCurve(const QString& name, const QString& details);
    [[nodiscard]] double offset() const;  ///< [m]

Q_SIGNALS:
    void offsetChanged();
    void removeChosen();

private:
    void showName();
    void resizeEvent(QResizeEvent* event) override;

    QLabel* name_;
    NumberBox* offset_;
    QString whole_;
};

}  // namespace asperity
