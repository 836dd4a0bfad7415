#include "app/charts/ChartFile.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/TextValue.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QHash>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <variant>

namespace asperity {

namespace {

constexpr const char* kSvg = "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"DejaVu Sans, "
                             "Arial, sans-serif\" viewBox=\"0 0 ";
constexpr double kInch = 96.0;  // [pixel of a page]
constexpr double kDash = 5.0;   // in widths of the line
constexpr double kGap = 3.0;
constexpr double kBaseline = 0.35;  // below the middle height, of the font's size

/// Colors of charts that each palette has its own of.
constexpr std::array kInks{&Palette::ink,    &Palette::muted, &Palette::faint,  &Palette::blue,
                           &Palette::orange, &Palette::green, &Palette::purple, &Palette::sky,
                           &Palette::yellow, &Palette::gray};

/// To a thousandth of a pixel, whatever the locale.
std::string number(double value) { return exactText(std::round(1000.0 * value) / 1000.0); }

/// XML has no U+FFFE and U+FFFF: they become U+FFFD. Source: XML 1.0, section 2.2.
std::string withoutNonCharacters(std::string text) {
    for (const std::string_view bytes : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
        for (std::size_t at = text.find(bytes); at != std::string::npos; at = text.find(bytes)) {
            text.replace(at, bytes.size(), "\xEF\xBF\xBD");
        }
    }
    return text;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + '"';
}
std::string attribute(const char* name, double value) { return attribute(name, number(value)); }

/// @param line width of it; 0: filled
std::string inked(const Color& color, double line) {
    return line > 0.0 ? " fill=\"none\"" + attribute("stroke", styleColor(color)) +
                            attribute("stroke-width", line)
                      : attribute("fill", styleColor(color));
}

std::string svgOf(const ChartPage::Box& box) {
    return "<rect" + inked(box.color, 0.0) + attribute("x", box.left) + attribute("y", box.top) +
           attribute("width", box.width) + attribute("height", box.height) + "/>\n";
}

std::string svgOf(const ChartPage::Line& line) {
    std::string svg = "<polyline" + inked(line.color, line.width) + " stroke-linejoin=\"round\"";
    if (line.dashed) {
        svg += attribute("stroke-dasharray",
                         number(kDash * line.width) + ' ' + number(kGap * line.width));
    }
    svg += " points=\"";
    for (const ChartPage::Point& point : line.points) {
        svg += number(point.x) + ',' + number(point.y) + ' ';
    }
    return svg + "\"/>\n";
}

std::string svgOf(const ChartPage::Dot& dot) {
    return "<circle" + inked(dot.color, dot.line) + attribute("cx", dot.center.x) +
           attribute("cy", dot.center.y) + attribute("r", dot.radius) + "/>\n";
}

std::string svgOf(const ChartPage::Text& text) {
    constexpr std::array kAnchors{"start", "middle", "end"};
    return "<text" + inked(text.color, 0.0) + attribute("font-size", text.size) +
           attribute("text-anchor", kAnchors.at(static_cast<std::size_t>(text.anchor))) +
           (text.bold ? " font-weight=\"bold\"" : "") +
           attribute("transform", "translate(" + number(text.at.x) + ',' + number(text.at.y) + ')' +
                                      (text.upright ? " rotate(-90)" : "")) +
           attribute("y", kBaseline * text.size) + '>' + escaped(text.text) + "</text>\n";
}

std::string svgParts(const ChartPage& page) {
    std::string svg;
    for (const auto& part : page.parts) {
        svg += std::visit([](const auto& drawn) { return svgOf(drawn); }, part);
    }
    return svg + "</svg>\n";
}

/// Paints each kind of part, whose lengths the painter scales.
struct PartPainter {
    QPainter& painter;
    double scale;  ///< of the painter

    void operator()(const ChartPage::Box& box) const;
    void operator()(const ChartPage::Line& line) const;
    void operator()(const ChartPage::Dot& dot) const;
    void operator()(const ChartPage::Text& text) const;
};

void PartPainter::operator()(const ChartPage::Box& box) const {
    painter.fillRect(QRectF(box.left, box.top, box.width, box.height), colorForQt(box.color));
}

void PartPainter::operator()(const ChartPage::Dot& dot) const {
    const QColor color = colorForQt(dot.color);
    painter.setPen(dot.line > 0.0 ? QPen(color, dot.line) : QPen(Qt::NoPen));
    painter.setBrush(dot.line > 0.0 ? QBrush(Qt::NoBrush) : QBrush(color));
    painter.drawEllipse(QPointF(dot.center.x, dot.center.y), dot.radius, dot.radius);
}

void PartPainter::operator()(const ChartPage::Line& line) const {
    QPen pen(colorForQt(line.color), line.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (line.dashed) {
        pen.setDashPattern({kDash, kGap});
    }
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    QPolygonF points;
    for (const ChartPage::Point& point : line.points) {
        points << QPointF(point.x, point.y);
    }
    painter.drawPolyline(points);
}

/// The font has its size on the device, as the painter's scale acts on what it measures.
void PartPainter::operator()(const ChartPage::Text& text) const {
    QFont font = drawnFont();
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(scale * text.size))));
    font.setBold(text.bold);
    const QString words = QString::fromStdString(printable(text.text));
    const double width = QFontMetricsF(font, painter.device()).horizontalAdvance(words);
    const double before = 0.5 * static_cast<double>(text.anchor);
    painter.save();
    painter.setFont(font);
    painter.setPen(colorForQt(text.color));
    painter.translate(text.at.x, text.at.y);
    painter.rotate(text.upright ? -90.0 : 0.0);
    painter.scale(1.0 / scale, 1.0 / scale);
    painter.drawText(QPointF(-before * width, kBaseline * scale * text.size), words);
    painter.restore();
}

/// Qt says its version and the time: neither is of the page, and the same page gives the same
/// bytes.
void forget(QByteArray& pdf, const char* entry) {
    const int begin = pdf.indexOf(entry);
    const int end = pdf.indexOf('\n', begin);
    if (begin >= 0 && end > begin) {
        pdf.replace(begin, end - begin, QByteArray(end - begin, ' '));
    }
}

/// Qt's hashes in the same order each time, as long as this lives: a PDF has its fonts in that of
/// one, and by chance the order differs from run to run.
struct SteadyHashes {
    SteadyHashes() { qSetGlobalQHashSeed(0); }
    ~SteadyHashes() { qSetGlobalQHashSeed(-1); }
    SteadyHashes(const SteadyHashes&) = delete;
    SteadyHashes& operator=(const SteadyHashes&) = delete;
};

void write(const std::filesystem::path& path, const char* bytes, std::ptrdiff_t size) {
    OutputFile file(path);
    file.stream().write(bytes, size);
    file.commit();
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char letter : withoutNonCharacters(printable(text))) {
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
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default:
            safe += letter;
        }
    }
    return safe;
}

std::string styleColor(const Color& color) {
    return formatted("#%02x%02x%02x", color.red, color.green, color.blue);
}

QColor colorForQt(const Color& color) { return {color.red, color.green, color.blue}; }

QFont drawnFont(const char* family) {
    QFont font(QString::fromLatin1(family));
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64.0);  // any at all: no ligatures
    return font;
}

std::string svgOf(const ChartPage& page, const std::string& description) {
    return kSvg + number(page.width) + ' ' + number(page.height) + "\" role=\"img\"" +
           attribute("aria-label", escaped(description)) + ">\n" + svgParts(page);
}

std::string svgStyle(const Palette& colors) {
    std::string style;
    for (const auto ink : kInks) {
        const std::string own = styleColor(kLightPalette.*ink);
        const std::string color = styleColor(colors.*ink);
        for (const char* use : {"stroke", "fill"}) {
            style += formatted("svg [%s=\"%s\"]{%s:%s}\n", use, own.c_str(), use, color.c_str());
        }
    }
    return style;
}

void paint(QPainter& painter, const ChartPage& page, double scale) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    for (const auto& part : page.parts) {
        std::visit(PartPainter{painter, scale}, part);
    }
    painter.restore();
}

QImage drawn(const ChartPage& page, double ratio, bool isTransparent) {
    QImage image(static_cast<int>(std::lround(ratio * page.width)),
                 static_cast<int>(std::lround(ratio * page.height)),
                 QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) {
        throw Error("Not enough memory to draw " + std::to_string(std::lround(ratio * page.width)) +
                    " x " + std::to_string(std::lround(ratio * page.height)) +
                    " pixels; choose a smaller picture");
    }
    image.fill(isTransparent ? QColor(Qt::transparent) : colorForQt(kLightPalette.paper));
    QPainter painter(&image);
    paint(painter, page, ratio);
    return image;
}

void writeSvg(const std::filesystem::path& path, const ChartPage& page, bool isTransparent) {
    const auto millimeters = [](double length) { return number(25.4 / kInch * length) + "mm"; };
    const std::string svg =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + (kSvg + number(page.width)) + ' ' +
        number(page.height) + '"' + attribute("width", millimeters(page.width)) +
        attribute("height", millimeters(page.height)) + ">\n" +
        (isTransparent
             ? ""
             : "<rect width=\"100%\" height=\"100%\"" + inked(kLightPalette.paper, 0.0) + "/>\n") +
        svgParts(page);
    write(path, svg.data(), std::ssize(svg));
}

void writePng(const std::filesystem::path& path, const ChartPage& page) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    drawn(page).convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG");
    write(path, bytes.constData(), bytes.size());
}

void writePdf(const std::filesystem::path& path, const std::string& title,
              const QPageLayout& layout,
              const std::function<void(QPdfWriter& writer, QPainter& painter)>& draw) {
    const SteadyHashes steady;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(printable(title)));
    writer.setCreator(QStringLiteral("Asperity ") + QString::fromLatin1(kVersion));
    writer.setResolution(kPdfResolution);
    writer.setPageLayout(layout);
    QPainter painter(&writer);
    painter.setRenderHint(QPainter::LosslessImageRendering);
    draw(writer, painter);
    painter.end();
    forget(bytes, "/Producer ");
    forget(bytes, "/CreationDate ");
    write(path, bytes.constData(), bytes.size());
}

void writePdf(const std::filesystem::path& path, const ChartPage& page, bool isTransparent) {
    constexpr double kPoints = 72.0 / kInch;
    const QPageSize size(QSizeF(kPoints * page.width, kPoints * page.height), QPageSize::Point, {},
                         QPageSize::ExactMatch);
    writePdf(path, "", QPageLayout(size, QPageLayout::Portrait, {}),
             [&](QPdfWriter&, QPainter& painter) {
                 constexpr double kScale = kPdfResolution / kInch;
                 if (!isTransparent) {
                     painter.fillRect(QRectF(0.0, 0.0, kScale * page.width, kScale * page.height),
                                      colorForQt(kLightPalette.paper));
                 }
                 paint(painter, page, kScale);
             });
}

}  // namespace asperity
