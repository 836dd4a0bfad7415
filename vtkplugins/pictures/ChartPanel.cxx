#include "vtkplugins/pictures/ChartPanel.h"

#include "vtkplugins/pictures/Decimation.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr double kChartTitle = 38.0;
constexpr double kAboveAxes = 10.0;
constexpr double kChartLeft = 96.0;  // tick labels and name of the y axis
constexpr double kChartBelow = 66.0;
constexpr double kChartRight = 28.0;
constexpr double kTickWidth = 90.0;  // least distance of ticks
constexpr double kTickHeight = 36.0;
constexpr double kDot = 9.0;
constexpr double kLabelSize = 15.0;

constexpr int kDrawn = OffscreenPicture::kOversampling;

std::vector<double> allValues(const Chart& chart, std::vector<double> Curve::*values) {
    std::vector<double> all;
    for (const Curve& curve : chart.curves) {
        all.insert(all.end(), (curve.*values).begin(), (curve.*values).end());
    }
    return all;
}

/// The curve in the axes' numbers, without samples that have no place there.
Series placed(const Curve& curve, const ChartAxis& xAxis, const ChartAxis& yAxis) {
    Series series;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double x = xAxis.place(curve.x[i]);
        const double y = yAxis.place(curve.y[i]);
        if (std::isfinite(x) && std::isfinite(y)) {
            series.x.push_back(x);
            series.y.push_back(y);
        }
    }
    return series;
}

/// From the lower ends of the axes: where those are a hundred times the range of an axis, VTK
/// shifts the values itself, and only when it draws for the second time.
vtkSmartPointer<vtkTable> tableOf(const Series& series, const ChartAxis& xAxis,
                                  const ChartAxis& yAxis) {
    auto table = vtkSmartPointer<vtkTable>::New();
    const std::array<const std::vector<double>*, 2> columns{&series.x, &series.y};
    const std::array<double, 2> begins{xAxis.low(), yAxis.low()};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        vtkNew<vtkDoubleArray> column;
        column->SetName(i == 0 ? "x" : "y");
        for (const double value : *columns[i]) {
            column->InsertNextValue(value - begins.at(i));
        }
        table->AddColumn(column);
    }
    return table;
}

void setUpAxis(vtkAxis* axis, const ChartAxis& shown) {
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(0.0, shown.high() - shown.low());  // as tableOf() has it
    axis->SetTitle("");  // the painter writes: it knows how much room there is
    axis->SetLabelsVisible(false);
    vtkNew<vtkDoubleArray> ticks;
    for (const double tick : shown.ticks()) {
        ticks->InsertNextValue(tick - shown.low());
    }
    axis->SetCustomTickPositions(ticks);
    axis->GetPen()->SetColor(kLightPalette.muted.red, kLightPalette.muted.green,
                             kLightPalette.muted.blue);
    axis->GetPen()->SetWidth(1.2F * kDrawn);
    axis->GetGridPen()->SetColor(kLightPalette.faint.red, kLightPalette.faint.green,
                                 kLightPalette.faint.blue);
    axis->GetGridPen()->SetWidth(1.0F * kDrawn);
}

}  // namespace

ChartPanel::ChartPanel(OffscreenPicture& picture, const Chart& chart, const PixelRect& area)
    : chart_(chart)
    , area_(area)
    , x_({chart.xLabel, chart.xUnit, chart.logX, static_cast<int>(plotArea().width / kTickWidth)},
         allValues(chart, &Curve::x))
    , y_({chart.yLabel, chart.yUnit, chart.logY, static_cast<int>(plotArea().height / kTickHeight)},
         allValues(chart, &Curve::y)) {
    addPlots(picture);
}

PixelRect ChartPanel::plotArea() const {
    return {area_.left + kChartLeft, area_.bottom + kChartBelow,
            area_.width - kChartLeft - kChartRight,
            area_.height - kChartTitle - legendHeight() - kAboveAxes - kChartBelow};
}

double ChartPanel::legendHeight() const {
    return legendHeightFor(legend(), area_.width - kChartLeft - kChartRight);
}

std::vector<LegendEntry> ChartPanel::legend() const {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
        const Curve& curve = chart_.curves[i];
        if (!curve.label.empty()) {
            entries.push_back({colorOf(i), curve.label,
                               curve.points   ? LegendMark::Point
                               : curve.dashed ? LegendMark::DashedLine
                                              : LegendMark::Line});
        }
    }
    return entries;
}

Color ChartPanel::colorOf(std::size_t curve) const {
    return chart_.curves[curve].color.value_or(seriesColor(kLightPalette, curve));
}

PixelPoint ChartPanel::pixelOf(double x, double y) const {
    const PixelRect plot = plotArea();
    return {plot.left + (x - x_.low()) / (x_.high() - x_.low()) * plot.width,
            plot.bottom + (y - y_.low()) / (y_.high() - y_.low()) * plot.height};
}

void ChartPanel::addPlots(OffscreenPicture& picture) const {
    const PixelRect plot = plotArea();
    vtkNew<vtkChartXY> chart;
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetSize(vtkRectf(
        static_cast<float>(plot.left * kDrawn), static_cast<float>(plot.bottom * kDrawn),
        static_cast<float>(plot.width * kDrawn), static_cast<float>(plot.height * kDrawn)));
    setUpAxis(chart->GetAxis(vtkAxis::BOTTOM), x_);
    setUpAxis(chart->GetAxis(vtkAxis::LEFT), y_);
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
        const Curve& curve = chart_.curves[i];
        Series series = placed(curve, x_, y_);
        if (series.x.empty()) {
            continue;
        }
        if (!curve.points) {
            series = decimateMinMax(series, static_cast<std::size_t>(plot.width * kDrawn));
        }
        vtkPlot* drawn = chart->AddPlot(curve.points ? vtkChart::POINTS : vtkChart::LINE);
        drawn->SetInputData(tableOf(series, x_, y_), 0, 1);
        const Color color = colorOf(i);
        drawn->SetColor(color.red, color.green, color.blue, 255);
        drawn->SetWidth((curve.points ? 1.0F : 2.0F) * kDrawn);
        drawn->GetPen()->SetLineType(curve.dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
        if (auto* dots = vtkPlotPoints::SafeDownCast(drawn); dots != nullptr && curve.points) {
            dots->SetMarkerStyle(vtkPlotPoints::CIRCLE);
            dots->SetMarkerSize(static_cast<float>(curve.dotSize * kDrawn));
        }
    }
    picture.addItem(chart);
}

void ChartPanel::paint(Painter& painter) const {
    const PixelRect plot = plotArea();
    painter.paragraph({plot.left, area_.top() - kChartTitle, plot.width, kChartTitle - 8.0},
                      chart_.title, {.size = 20.0, .bold = true});
    paintLegend(painter, legend(),
                {plot.left, plot.top() + kAboveAxes, plot.width, legendHeight()});
    paintAxes(painter);
    paintPointLabels(painter);
}

void ChartPanel::paintAxes(Painter& painter) const {
    const PixelRect plot = plotArea();
    for (std::size_t i = 0; i < x_.ticks().size(); ++i) {
        painter.text({pixelOf(x_.ticks()[i], y_.low()).x, plot.bottom - 18.0}, x_.labels()[i],
                     {.size = kLabelSize, .align = Align::Center});
    }
    for (std::size_t i = 0; i < y_.ticks().size(); ++i) {
        painter.text({plot.left - 10.0, pixelOf(x_.low(), y_.ticks()[i]).y}, y_.labels()[i],
                     {.size = kLabelSize, .align = Align::Right});
    }
    const TextStyle name{.size = 16.0, .align = Align::Center};
    painter.text({plot.left + 0.5 * plot.width, plot.bottom - 44.0}, x_.title(), name);
    painter.upright({area_.left + 16.0, plot.bottom + 0.5 * plot.height}, y_.title(), name);
}

void ChartPanel::blockWhatIsDrawn(LabelPlacer& placer) const {
    for (const Curve& curve : chart_.curves) {
        const Series series = placed(curve, x_, y_);
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            const PixelPoint here = pixelOf(series.x[i], series.y[i]);
            if (curve.points) {
                placer.blockDot(here);
            } else if (i > 0) {
                placer.blockLine(pixelOf(series.x[i - 1], series.y[i - 1]), here);
            }
        }
    }
}

void ChartPanel::paintPointLabels(Painter& painter) const {
    if (std::all_of(chart_.curves.begin(), chart_.curves.end(),
                    [](const Curve& curve) { return curve.pointLabels.empty(); })) {
        return;
    }
    const TextStyle style{.size = kLabelSize};
    LabelPlacer placer(plotArea(), kDot);
    blockWhatIsDrawn(placer);
    for (const Curve& curve : chart_.curves) {
        for (std::size_t i = 0; i < curve.pointLabels.size(); ++i) {
            const PixelPoint dot = pixelOf(x_.place(curve.x[i]), y_.place(curve.y[i]));
            if (std::isfinite(dot.x) && std::isfinite(dot.y)) {
                const std::string& label = curve.pointLabels[i];
                const PixelRect place =
                    placer.place(dot, painter.textWidth(label, style) + 2.0, kLabelSize * 1.2);
                painter.text({place.left, place.bottom + 0.5 * place.height}, label, style);
            }
        }
    }
}

}  // namespace asperity
