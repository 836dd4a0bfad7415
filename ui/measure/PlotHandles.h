#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include <QObject>
#include <QVector>

class QWidget;

namespace asperity {

class PlotNavigation;

/// Places along the horizontal axis of a plot that a user can drag. Where no such place is near the
/// pointer, the mouse does what PlotNavigation says.
class PlotHandles : public QObject {
    Q_OBJECT

public:
    /// @param canvas of the plot, whose navigation is there already; both outlive this
    PlotHandles(QWidget& canvas, const PlotNavigation& navigation);

    void setPlaces(const QVector<double>& places) { places_ = places; }

Q_SIGNALS:
    void dragged(int index, double place);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// The nearest one within reach of a pixel; -1: none.
    [[nodiscard]] int handleAt(double pixel) const;

    QWidget& canvas_;
    const PlotNavigation& navigation_;
    QVector<double> places_;
    int held_ = -1;
};

}  // namespace asperity
