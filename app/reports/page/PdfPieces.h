#pragma once

#include "app/reports/page/ReportPage.h"

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPointF>
#include <QString>
#include <QTextLayout>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class QPaintDevice;

namespace asperity {

/// Something on a sheet that is never cut. Lengths are those of the device.
struct PdfPiece {
    double space = 0.0;  ///< to what is above it, but not at the top of a sheet
    double height = 0.0;
    bool keepsNext = false;  ///< the next one is on the same sheet
    std::function<void(QPainter& painter, const QPointF& corner)> draw;
    std::shared_ptr<const PdfPiece> head = nullptr;  ///< drawn above it at the top of a sheet
};

/// A piece with its position on a sheet.
struct PlacedPiece {
    double y = 0.0;  ///< of its upper edge, below the margin
    const PdfPiece* piece = nullptr;
};

/// The sheets that the pieces fill, in order. @param height of a sheet between its margins
[[nodiscard]] std::vector<std::vector<PlacedPiece>> onSheets(const std::vector<PdfPiece>& pieces,
                                                             double height);

/// Style of the blocks of a page, for one device. Lengths are those of the device.
class PdfStyle {
public:
    explicit PdfStyle(QPaintDevice& device, double width);

    [[nodiscard]] QPaintDevice& device() const { return device_; }
    [[nodiscard]] double width() const { return width_; }  ///< of the text
    [[nodiscard]] double points(double count) const { return count * point_; }

    [[nodiscard]] static QFont text(double size, bool bold = false);  ///< @param size [pt]
    [[nodiscard]] static QFont code(double size);                     ///< @param size [pt]

private:
    QPaintDevice& device_;
    double width_;
    double point_;  ///< in lengths of the device
};

/// Style of a text. Lengths are those of the device.
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

/// Width of a text in one line, and of its longest word.
struct PdfTextWidth {
    double line = 0.0;
    double word = 0.0;
};
[[nodiscard]] PdfTextWidth widthOf(const std::string& text, const QFont& font,
                                   QPaintDevice& device);

/// The rows of a table, each a piece; columns are as wide as their texts need and the sheet has.
[[nodiscard]] std::vector<PdfPiece> tablePieces(const PageTable& table, const PdfStyle& style);

}  // namespace asperity
