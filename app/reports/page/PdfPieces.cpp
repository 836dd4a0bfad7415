#include "app/reports/page/PdfPieces.h"

#include "app/charts/ChartFile.h"
#include "core/PrintableText.h"

#include <QPaintDevice>
#include <QStringList>
#include <QTextOption>
#include <QUrl>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace asperity {

namespace {

/// Returns the height of a piece and all that are kept with it.
double heightTogether(const std::vector<PdfPiece>& pieces, std::size_t first) {
    double height = pieces[first].height;
    for (std::size_t i = first; pieces[i].keepsNext && i + 1 < pieces.size(); ++i) {
        height += pieces[i + 1].space + pieces[i + 1].height;
    }
    return height;
}

}  // namespace

std::vector<std::vector<PlacedPiece>> onSheets(const std::vector<PdfPiece>& pieces, double height) {
    std::vector<std::vector<PlacedPiece>> sheets(1);
    double y = 0.0;
    bool isKept = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PdfPiece& piece = pieces[i];
        const bool isFull =
            !isKept && y > 0.0 && y + piece.space + heightTogether(pieces, i) > height;
        // Pieces kept together may be higher than a sheet.
        const bool isOver = isKept && y + piece.space + piece.height > height;
        if (isFull || isOver) {
            sheets.emplace_back();
            y = 0.0;
            if (piece.head) {
                sheets.back().push_back({y, piece.head.get()});
                y += piece.head->height;
            }
        }
        y += y > 0.0 ? piece.space : 0.0;
        sheets.back().push_back({y, &piece});
        y += piece.height;
        isKept = piece.keepsNext;
    }
    return sheets;
}

namespace {

constexpr double kPointsPerInch = 72.0;

QFont fontOf(const char* family, double size) {
    QFont font = drawnFont(family);
    font.setPointSizeF(size);
    return font;
}

}  // namespace

PdfStyle::PdfStyle(QPaintDevice& device, double width)
    : device_(device), width_(width), point_(device.logicalDpiX() / kPointsPerInch) {}

QFont PdfStyle::text(double size, bool bold) {
    QFont font = fontOf("DejaVu Sans", size);
    font.setBold(bold);
    return font;
}

QFont PdfStyle::code(double size) { return fontOf("DejaVu Sans Mono", size); }

namespace {

QString shown(const std::string& text) { return QString::fromStdString(printable(text)); }

/// Returns the width in the layout: font metrics differ from it in the last bits.
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

namespace {

constexpr std::array kTextSizes{7.5, 7.0, 6.5};  // the first that leaves all words whole [pt]
constexpr double kGap = 6.0;                     // between columns [pt]
constexpr double kRowPadding = 2.0;              // above and below a row's text [pt]
constexpr double kLine = 0.5;                    // [pt]
constexpr double kMaxWords = 0.35;               // of the width, that a single word may claim

/// Column by column.
struct ColumnWidths {
    std::vector<double> title;  ///< in one line
    std::vector<double> line;   ///< of the cells, in one line each; titles may take several
    std::vector<double> word;   ///< of the longest word

    explicit ColumnWidths(std::size_t columns) : title(columns), line(columns), word(columns) {}

    void takeTitle(std::size_t column, const PdfTextWidth& width) {
        title[column] = width.line;
        takeCell(column, {width.word, width.word});
    }
    void takeCell(std::size_t column, const PdfTextWidth& width) {
        line[column] = std::max(line[column], width.line);
        word[column] = std::max(word[column], width.word);
    }
    /// All in one line.
    [[nodiscard]] std::vector<double> whole() const {
        std::vector<double> widths = line;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            widths[i] = std::max(widths[i], title[i]);
        }
        return widths;
    }
};

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Widths that fill no more than there is: each column has room for its longest word, if there is
/// room for all of these, and a share of what is left by what it could use.
std::vector<double> fitted(const ColumnWidths& wanted, double room) {
    for (const std::vector<double>& widths : {wanted.whole(), wanted.line}) {
        if (sum(widths) <= room) {
            return widths;
        }
    }
    std::vector<double> widths = wanted.word;
    for (double& width : widths) {
        width = std::min(width, kMaxWords * room);
    }
    const double least = sum(widths);
    if (least >= room) {
        for (double& width : widths) {
            width *= room / least;
        }
        return widths;
    }
    const double share = (room - least) / (sum(wanted.line) - least);
    for (std::size_t i = 0; i < widths.size(); ++i) {
        widths[i] += share * std::max(0.0, wanted.line[i] - widths[i]);
    }
    return widths;
}

class TablePieces {
public:
    TablePieces(const PageTable& table, const PdfStyle& style) : table_(table), style_(style) {
        const double gaps = style.points(kGap) * static_cast<double>(table.columns.size() - 1);
        const double room = style.width() - gaps;
        for (const double size : kTextSizes) {
            size_ = size;
            const ColumnWidths wanted = widthsWanted();
            widths_ = fitted(wanted, room);
            if (sum(wanted.word) <= room) {
                break;
            }
        }
    }

    [[nodiscard]] std::vector<PdfPiece> pieces() const {
        std::vector<PdfPiece> pieces;
        std::shared_ptr<const PdfPiece> head;
        if (table_.hasTitles) {
            PdfPiece titles = rowPiece(titleTexts());
            titles.keepsNext = true;
            head = std::make_shared<PdfPiece>(titles);
            pieces.push_back(std::move(titles));
        }
        for (const auto& row : table_.rows) {
            pieces.push_back(rowPiece(textsOf(row)));
            pieces.back().head = head;
        }
        if (!pieces.empty()) {
            pieces.front().space = style_.points(4.0);
        }
        return pieces;
    }

private:
    [[nodiscard]] ColumnWidths widthsWanted() const {
        ColumnWidths wanted(table_.columns.size());
        for (std::size_t i = 0; i < table_.columns.size(); ++i) {
            wanted.takeTitle(i, widthIn(titleOf(i), titleFont()));
            for (const auto& row : table_.rows) {
                wanted.takeCell(i, widthIn(row[i].text, fontOf(i)));
            }
        }
        return wanted;
    }
    [[nodiscard]] std::string titleOf(std::size_t column) const {
        return table_.hasTitles ? table_.columns[column].title : std::string();
    }
    [[nodiscard]] QFont titleFont() const { return PdfStyle::text(size_, true); }
    [[nodiscard]] QFont fontOf(std::size_t column) const {
        return !table_.hasTitles && column == 0 ? titleFont() : PdfStyle::text(size_);
    }
    [[nodiscard]] PdfTextWidth widthIn(const std::string& text, const QFont& font) const {
        return widthOf(text, font, style_.device());
    }
    [[nodiscard]] PdfText textOf(const std::string& text, std::size_t column, const QFont& font,
                                 const QColor& color, const QString& link = {}) const {
        const bool isNumber = table_.columns[column].isNumber;
        return {text,
                {.font = font,
                 .color = color,
                 .alignment = isNumber ? Qt::AlignRight : Qt::AlignLeft,
                 .link = link},
                widths_[column],
                style_.device()};
    }

    [[nodiscard]] std::vector<PdfText> titleTexts() const {
        std::vector<PdfText> texts;
        for (std::size_t i = 0; i < table_.columns.size(); ++i) {
            texts.push_back(
                textOf(table_.columns[i].title, i, titleFont(), colorForQt(kLightPalette.muted)));
        }
        return texts;
    }

    [[nodiscard]] std::vector<PdfText> textsOf(const std::vector<PageCell>& row) const {
        std::vector<PdfText> texts;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool leads = !row[i].page.empty();
            const QString link = leads ? QString::fromLatin1(QUrl::toPercentEncoding(
                                             QString::fromStdString(row[i].page + ".pdf")))
                                       : QString();
            texts.push_back(textOf(row[i].text, i, fontOf(i),
                                   colorForQt(leads ? kLightPalette.accent : kLightPalette.ink),
                                   link));
        }
        return texts;
    }

    [[nodiscard]] PdfPiece rowPiece(std::vector<PdfText> texts) const {
        double height = 0.0;
        for (const PdfText& text : texts) {
            height = std::max(height, text.height());
        }
        const double padding = style_.points(kRowPadding);
        height += 2.0 * padding;
        const auto draw = [texts = std::move(texts), widths = widths_, gap = style_.points(kGap),
                           line = style_.points(kLine), padding,
                           height](QPainter& painter, const QPointF& corner) {
            double x = corner.x();
            for (std::size_t i = 0; i < texts.size(); ++i) {
                texts[i].draw(painter, {x, corner.y() + padding});
                x += widths[i] + gap;
            }
            painter.setPen(QPen(colorForQt(kLightPalette.faint), line));
            painter.drawLine(QPointF(corner.x(), corner.y() + height),
                             QPointF(x - gap, corner.y() + height));
        };
        return {.height = height, .draw = draw};
    }

    const PageTable& table_;
    const PdfStyle& style_;
    double size_ = 0.0;  ///< of the text [pt]
    std::vector<double> widths_;
};

}  // namespace

std::vector<PdfPiece> tablePieces(const PageTable& table, const PdfStyle& style) {
    return TablePieces(table, style).pieces();
}

}  // namespace asperity
