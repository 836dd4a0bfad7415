#include "app/reports/page/PdfText.h"

#include "core/PrintableText.h"

#include <QFontMetricsF>
#include <QStringList>
#include <QTextOption>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

QString shown(const std::string& text) { return QString::fromStdString(printable(text)); }

}  // namespace

PdfText::PdfText(const std::string& text, const PdfTextStyle& style, double width,
                 QPaintDevice& device)
    : layout_(std::make_shared<QTextLayout>(shown(text), style.font, &device)) {
    QTextOption option(style.alignment);
    option.setWrapMode(style.anywhere ? QTextOption::WrapAnywhere
                                      : QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout_->setTextOption(option);
    QTextLayout::FormatRange all;
    all.start = 0;
    all.length = layout_->text().size();
    all.format.setForeground(style.color);
    if (!style.link.isEmpty()) {
        all.format.setAnchor(true);
        all.format.setAnchorHref(style.link);
    }
    layout_->setFormats({all});
    layout_->beginLayout();
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
        line.setLineWidth(width);
        line.setPosition({0.0, height_});
        height_ += line.height();
    }
    layout_->endLayout();
}

PdfTextWidth widthOf(const std::string& text, const QFont& font, QPaintDevice& device) {
    const QFontMetricsF metrics(font, &device);
    const QString all = shown(text);
    PdfTextWidth width;
    width.line = std::ceil(metrics.horizontalAdvance(all)) + 1.0;
    for (const QString& word : all.split(QLatin1Char(' '))) {
        width.word = std::max(width.word, std::ceil(metrics.horizontalAdvance(word)) + 1.0);
    }
    return width;
}

}  // namespace asperity
