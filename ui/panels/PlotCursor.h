#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include <QColor>
#include <QPointF>
#include <QString>
#include <QVector>

#include <optional>

class QwtPlot;
class QwtPlotCurve;
class QwtPlotMarker;
class QwtPlotTextLabel;

namespace asperity {

/// A vertical line in a plot with what the curves say there, written at the top of the canvas. The
/// plot owns what is drawn.
class PlotCursor {
public:
    explicit PlotCursor(QwtPlot& plot);

    /// @param x on the plot's axis @param text rich text, one line
    void show(double x, const QString& text);
    void hide();

    /// Without its markup; empty: it is hidden.
    [[nodiscard]] const QString& text() const { return text_; }

private:
    QwtPlotMarker* line_;
    QwtPlotTextLabel* label_;
    QString text_;
};

/// The sample of a curve that is nearest to x; samples that are not numbers do not count.
[[nodiscard]] std::optional<QPointF> nearestSample(const QwtPlotCurve& curve, double x);

/// One value in the color of its curve: "Fx 1.2 nN".
[[nodiscard]] QString coloredReading(const QColor& color, const QString& text);

}  // namespace asperity
