#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPointF>
#include <QString>
#include <QTextLayout>

#include <memory>
#include <string>

class QPaintDevice;

namespace asperity {

/// How a text is set. Lengths are those of the device.
struct PdfTextStyle {
    QFont font;
    QColor color;
    Qt::Alignment alignment = Qt::AlignLeft;
    bool anywhere = false;  ///< lines may end within a word, too
    QString link = {};      ///< empty: none
};

/// A text in lines of at most a width.
class PdfText {
public:
    PdfText(const std::string& text, const PdfTextStyle& style, double width, QPaintDevice& device);

    [[nodiscard]] double height() const { return height_; }
    void draw(QPainter& painter, const QPointF& corner) const { layout_->draw(&painter, corner); }

private:
    std::shared_ptr<QTextLayout> layout_;
    double height_ = 0.0;
};

/// How wide a text is in one line, and how wide its longest word is.
struct PdfTextWidth {
    double line = 0.0;
    double word = 0.0;
};
[[nodiscard]] PdfTextWidth widthOf(const std::string& text, const QFont& font,
                                   QPaintDevice& device);

}  // namespace asperity
