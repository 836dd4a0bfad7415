#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QVector>
#include <qwt_plot_curve.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

#include <optional>
#include <vector>

// Compiled as C++17 too: Qwt's headers are not C++20.
class QToolButton;
class QwtPlot;
class QwtPlotCurve;
class QwtPlotMarker;
class QwtPlotTextLabel;

// Parts that the live plots share.
namespace asperity {

/// A curve in pieces: a value that is not a number parts two of them.
class PiecewiseCurve : public QwtPlotCurve {
public:
    // NOLINTNEXTLINE(readability-function-size): the parameters are Qwt's
    void drawSeries(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                    const QRectF& canvas, int from, int to) const override;
};

/// Numbers with the same count of decimals at every tick, and a unit after each where there is one.
class NumberScaleDraw : public QwtScaleDraw {
public:
    void set(int decimals, const QString& unit = {});
    [[nodiscard]] QwtText label(double value) const override;

private:
    int decimals_ = 0;
    QString unit_;
};

/// Returns how many decimals tell these ticks apart.
[[nodiscard]] int decimalsFor(const std::vector<double>& ticks);

[[nodiscard]] QwtScaleDiv divisions(double low, double high, const std::vector<double>& ticks);

/// A plot on paper with gray axes, a grid below what is attached later, and no frame.
void styleLivePlot(QwtPlot& plot);
/// Colors of the lines and of the numbers of all axes.
void colorAxes(QwtPlot& plot, const QColor& lines, const QColor& numbers);
/// A line at zero force or value.
void addZeroLine(QwtPlot& plot);
/// The button that ends zooming, as high as its line [px]; hidden at first.
void styleResetButton(QToolButton& button, int height);
/// Lays a plot out under a line with its title, the button at the line's end.
void placeUnderTitle(QWidget& owner, QWidget& title, QToolButton& reset, QwtPlot& plot);
/// What the title of a plot says of the panel that holds it.
[[nodiscard]] QString enlargeTip();
/// Keeps room for the first and last label of the horizontal axis, so that the canvas stays as wide
/// whatever its numbers.
void keepEndRoom(QwtPlot& plot);
/// Room for the labels of the value axis, so that the canvas stays where it is.
[[nodiscard]] double valueLabelRoom();

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
