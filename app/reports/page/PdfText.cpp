#include "app/reports/page/PdfText.h"

#include "core/PrintableText.h"

#include <QStringList>
#include <QTextOption>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

QString shown(const std::string& text) { return QString::fromStdString(printable(text)); }

/// As it is laid out: that is not to the last bit what font metrics say.
double widthInLine(const QString& text, const QFont& font, QPaintDevice& device) {
    QTextLayout layout(text, font, &device);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    if (line.isValid()) {  // there is a text
        line.setNumColumns(text.size());
    }
    layout.endLayout();
    return line.isValid() ? std::ceil(line.naturalTextWidth()) + 1.0 : 0.0;
}

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
    const QString all = shown(text);
    PdfTextWidth width;
    width.line = widthInLine(all, font, device);
    for (const QString& word : all.split(QLatin1Char(' '))) {
        width.word = std::max(width.word, widthInLine(word, font, device));
    }
    return width;
}

}  // namespace asperity
