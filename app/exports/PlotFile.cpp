#include "app/exports/PlotFile.h"

#include "app/exports/RasterPixels.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "ui/Theme.h"

#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace asperity {

namespace {

constexpr const char* kFont = "DejaVu Sans";
constexpr double kDash = 5.0;  // in widths of the line
constexpr double kGap = 3.0;
constexpr int kPdfResolution = 1200;  // of places and letters [dots an inch]

std::string colorText(const Color& color) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned value :
         {unsigned{color.red}, unsigned{color.green}, unsigned{color.blue}}) {
        text += kDigits[value / 16U];
        text += kDigits[value % 16U];
    }
    return text;
}

/// To a thousandth of a pixel, whatever the locale.
std::string number(double value) { return exactText(std::round(1000.0 * value) / 1000.0); }

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        switch (letter) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        default:
            safe += letter;
        }
    }
    return safe;
}

void writeLine(std::ostream& out, const PlotPage::Line& line) {
    out << "<polyline fill=\"none\" stroke=\"" << colorText(line.color) << "\" stroke-width=\""
        << number(line.width) << "\" stroke-linejoin=\"round\"";
    if (line.dashed) {
        out << " stroke-dasharray=\"" << number(kDash * line.width) << ' '
            << number(kGap * line.width) << '"';
    }
    out << " points=\"";
    for (const PlotPage::Point& point : line.points) {
        out << number(point.x) << ',' << number(point.y) << ' ';
    }
    out << "\"/>\n";
}

void writeText(std::ostream& out, const PlotPage::Text& text) {
    const char* anchor = text.align == Align::Left     ? "start"
                         : text.align == Align::Center ? "middle"
                                                       : "end";
    out << "<text font-size=\"" << number(text.size) << "\" fill=\"" << colorText(text.color)
        << "\" text-anchor=\"" << anchor << '"';
    if (text.bold) {
        out << " font-weight=\"bold\"";
    }
    out << " transform=\"translate(" << number(text.at.x) << ',' << number(text.at.y) << ')'
        << (text.upright ? " rotate(-90)" : "") << "\" y=\"" << number(0.35 * text.size) << "\">"
        << escaped(text.text) << "</text>\n";
}

/// Paints a page on anything of Qt.
class PagePainter {
public:
    /// @param scale pixels of the device per pixel of the page
    PagePainter(QPainter& painter, double scale) : painter_(painter), scale_(scale) {
        painter.setRenderHint(QPainter::Antialiasing);
    }

    void paint(const PlotPage& page) const {
        std::ranges::for_each(page.lines, [this](const auto& line) { paintLine(line); });
        std::ranges::for_each(page.dots, [this](const auto& dot) { paintDot(dot); });
        std::ranges::for_each(page.texts, [this](const auto& text) { paintText(text); });
    }

private:
    [[nodiscard]] QPointF at(const PlotPage::Point& point) const {
        return {scale_ * point.x, scale_ * point.y};
    }

    void paintLine(const PlotPage::Line& line) const {
        QPen pen(toQColor(line.color), scale_ * line.width, Qt::SolidLine, Qt::FlatCap,
                 Qt::RoundJoin);
        if (line.dashed) {
            pen.setDashPattern({kDash, kGap});
        }
        painter_.setPen(pen);
        painter_.setBrush(Qt::NoBrush);
        QPolygonF places;
        for (const PlotPage::Point& point : line.points) {
            places << at(point);
        }
        painter_.drawPolyline(places);
    }

    void paintDot(const PlotPage::Dot& dot) const {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(toQColor(dot.color));
        painter_.drawEllipse(at(dot.center), scale_ * dot.radius, scale_ * dot.radius);
    }

    void paintText(const PlotPage::Text& text) const {
        QFont font(QString::fromLatin1(kFont));
        font.setPixelSize(std::max(1, static_cast<int>(std::lround(scale_ * text.size))));
        font.setBold(text.bold);
        const QString words = QString::fromStdString(text.text);
        const QFontMetricsF metrics(font, painter_.device());
        const double width = metrics.horizontalAdvance(words);
        const double before = text.align == Align::Left     ? 0.0
                              : text.align == Align::Center ? 0.5
                                                            : 1.0;
        painter_.save();
        painter_.setFont(font);
        painter_.setPen(toQColor(text.color));
        painter_.translate(at(text.at));
        painter_.rotate(text.upright ? -90.0 : 0.0);
        painter_.drawText(QPointF(-before * width, 0.35 * scale_ * text.size), words);
        painter_.restore();
    }

    QPainter& painter_;
    double scale_;
};

}  // namespace

void writeSvg(const std::filesystem::path& path, const PlotPage& page, bool transparent) {
    constexpr double kMillimeters = 25.4 / 96.0;
    OutputFile file(path);
    std::ostream& out = file.stream();
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << number(kMillimeters * page.width)
        << "mm\" height=\"" << number(kMillimeters * page.height) << "mm\" viewBox=\"0 0 "
        << number(page.width) << ' ' << number(page.height) << "\" font-family=\"" << kFont
        << ", Arial, sans-serif\">\n";
    if (!transparent) {
        out << "<rect width=\"100%\" height=\"100%\" fill=\"" << colorText(kLightPalette.paper)
            << "\"/>\n";
    }
    std::ranges::for_each(page.lines, [&out](const auto& line) { writeLine(out, line); });
    for (const PlotPage::Dot& dot : page.dots) {
        out << "<circle cx=\"" << number(dot.center.x) << "\" cy=\"" << number(dot.center.y)
            << "\" r=\"" << number(dot.radius) << "\" fill=\"" << colorText(dot.color) << "\"/>\n";
    }
    std::ranges::for_each(page.texts, [&out](const auto& text) { writeText(out, text); });
    out << "</svg>\n";
    file.commit();
}

void writePdf(const std::filesystem::path& path, const PlotPage& page, bool transparent) {
    constexpr double kPoints = 72.0 / 96.0;
    const TemporaryFile file(path);
    {
        QPdfWriter writer(QString::fromStdString(file.path().string()));
        writer.setResolution(kPdfResolution);
        writer.setCreator(QStringLiteral("Asperity"));
        writer.setPageLayout(
            QPageLayout(QPageSize(QSizeF(kPoints * page.width, kPoints * page.height),
                                  QPageSize::Point, {}, QPageSize::ExactMatch),
                        QPageLayout::Portrait, {}));
        QPainter painter;
        if (!painter.begin(&writer)) {
            throw Error(path.string() + ": cannot be written");
        }
        const double scale = kPdfResolution / 96.0;
        if (!transparent) {
            painter.fillRect(QRectF(0.0, 0.0, scale * page.width, scale * page.height),
                             toQColor(kLightPalette.paper));
        }
        PagePainter(painter, scale).paint(page);
        if (!painter.end()) {
            throw Error(path.string() + ": writing stopped half-way (disk full?)");
        }
    }
    file.commit();
}

RasterImage drawnPage(const PlotPage& page, const PictureSpec& spec) {
    QImage drawn(spec.size.width, spec.size.height, QImage::Format_ARGB32_Premultiplied);
    if (drawn.isNull()) {
        throw Error("Not enough memory to draw so many pixels.");
    }
    drawn.fill(spec.transparent ? QColor(Qt::transparent) : toQColor(kLightPalette.paper));
    QPainter painter(&drawn);
    PagePainter(painter, spec.pixelRatio()).paint(page);
    painter.end();
    return rasterOf(drawn);
}

void writePlotPage(const std::filesystem::path& path, std::span<const Chart> charts,
                   const PictureSpec& spec, ExportFormat format) {
    const PlotPage page = plotPage(charts, spec);
    if (format == ExportFormat::Svg) {
        writeSvg(path, page, spec.transparent);
    } else if (format == ExportFormat::Pdf) {
        writePdf(path, page, spec.transparent);
    } else {
        writePicture(path, drawnPage(page, spec), format, spec.dpi);
    }
}

}  // namespace asperity
