#include "app/charts/ChartFile.h"
#include "app/reports/page/PdfPieces.h"
#include "app/reports/page/ReportPage.h"

#include <QImage>
#include <QPageLayout>
#include <QPdfWriter>

#include <algorithm>
#include <iterator>
#include <utility>

namespace asperity {

namespace {

constexpr double kTitleSize = 16.0;    // [pt]
constexpr double kHeadingSize = 11.5;  // [pt]
constexpr double kTextSize = 9.0;      // [pt]
constexpr double kCaptionSize = 8.0;   // [pt]
constexpr double kCodeSize = 7.5;      // [pt]
constexpr double kIndent = 10.0;       // of lists, and of what is marked [pt]
constexpr double kMark = 2.5;          // width of a mark beside a text [pt]

/// Makes pieces of each kind of block.
class BlockPieces {
public:
    explicit BlockPieces(const PdfStyle& style) : style_(style) {}

    std::vector<PdfPiece> operator()(const PageHeading& heading) const {
        PdfPiece piece =
            textPiece(heading.text, PdfStyle::text(kHeadingSize, true), kLightPalette.ink, 14.0);
        piece.keepsNext = true;
        return {piece};
    }

    std::vector<PdfPiece> operator()(const PageParagraph& paragraph) const {
        const QFont font = PdfStyle::text(kTextSize);
        if (paragraph.tone == PageTone::Plain) {
            return {textPiece(paragraph.text, font, kLightPalette.ink, 5.0)};
        }
        const bool isFault = paragraph.tone == PageTone::Fault;
        const Color& color = isFault ? kLightPalette.fault : kLightPalette.caution;
        PdfPiece piece =
            textPiece(paragraph.text, font, isFault ? color : kLightPalette.ink, 6.0, kIndent);
        piece.draw = [text = piece.draw, color, height = piece.height,
                      width = style_.points(kMark)](QPainter& painter, const QPointF& corner) {
            painter.fillRect(QRectF(corner, QSizeF(width, height)), colorForQt(color));
            text(painter, corner);
        };
        return {piece};
    }

    std::vector<PdfPiece> operator()(const PageList& list) const {
        std::vector<PdfPiece> pieces;
        for (const std::string& item : list.items) {
            PdfPiece piece = textPiece(item, PdfStyle::text(kTextSize), kLightPalette.ink,
                                       pieces.empty() ? 5.0 : 2.5, kIndent);
            const PdfText bullet =
                textOf("•", PdfStyle::text(kTextSize), kLightPalette.muted, style_.points(kIndent));
            piece.draw = [text = piece.draw, bullet](QPainter& painter, const QPointF& corner) {
                bullet.draw(painter, corner);
                text(painter, corner);
            };
            pieces.push_back(std::move(piece));
        }
        return pieces;
    }

    std::vector<PdfPiece> operator()(const PageCode& code) const {
        std::vector<PdfPiece> pieces;
        const double padding = style_.points(4.0);
        for (const std::string& line : code.lines) {
            const PdfText text(line,
                               {.font = PdfStyle::code(kCodeSize),
                                .color = colorForQt(kLightPalette.ink),
                                .anywhere = true},
                               style_.width() - 2.0 * padding, style_.device());
            const bool isFirst = pieces.empty();
            const double above = isFirst ? padding : 0.0;
            const double below = pieces.size() + 1 == code.lines.size() ? padding : 0.0;
            const double height = text.height() + above + below;
            pieces.push_back({.space = isFirst ? style_.points(5.0) : 0.0,
                              .height = height,
                              .draw = [text, above, padding, height, width = style_.width()](
                                          QPainter& painter, const QPointF& corner) {
                                  painter.fillRect(QRectF(corner, QSizeF(width, height)),
                                                   colorForQt(kLightPalette.window));
                                  text.draw(painter, corner + QPointF(padding, above));
                              }});
        }
        return pieces;
    }

    std::vector<PdfPiece> operator()(const PageTable& table) const {
        return tablePieces(table, style_);
    }

    std::vector<PdfPiece> operator()(const PagePicture& picture) const {
        const QImage image =
            QImage::fromData(reinterpret_cast<const uchar*>(picture.png.data()),  // bytes are bytes
                             static_cast<int>(picture.png.size()));
        if (image.isNull()) {
            return {};
        }
        const double width = 0.88 * style_.width();
        const QSizeF size(width, width * image.height() / image.width());
        return withCaption({.space = style_.points(6.0),
                            .height = size.height(),
                            .draw =
                                [image, size](QPainter& painter, const QPointF& corner) {
                                    painter.drawImage(QRectF(corner, size), image);
                                }},
                           picture.caption);
    }

    std::vector<PdfPiece> operator()(const PagePlot& plot) const {
        const ChartPage page = laidOut(plot);
        const double scale = std::min(style_.points(0.75), style_.width() / page.width);
        return withCaption({.space = style_.points(6.0),
                            .height = scale * page.height,
                            .draw =
                                [page, scale](QPainter& painter, const QPointF& corner) {
                                    painter.save();
                                    painter.translate(corner);
                                    paint(painter, page, scale);
                                    painter.restore();
                                }},
                           plot.caption);
    }

    [[nodiscard]] PdfPiece textPiece(const std::string& text, const QFont& font, const Color& color,
                                     double space, double indent = 0.0) const {
        const double left = style_.points(indent);
        const PdfText set = textOf(text, font, color, style_.width() - left);
        return {.space = style_.points(space),
                .height = set.height(),
                .draw = [set, left](QPainter& painter, const QPointF& corner) {
                    set.draw(painter, corner + QPointF(left, 0.0));
                }};
    }

private:
    [[nodiscard]] PdfText textOf(const std::string& text, const QFont& font, const Color& color,
                                 double width) const {
        return {text, {.font = font, .color = colorForQt(color)}, width, style_.device()};
    }

    [[nodiscard]] std::vector<PdfPiece> withCaption(PdfPiece piece,
                                                    const std::string& caption) const {
        if (caption.empty()) {
            return {piece};
        }
        piece.keepsNext = true;
        return {piece, textPiece(caption, PdfStyle::text(kCaptionSize), kLightPalette.muted, 3.0)};
    }

    const PdfStyle& style_;
};

/// All of a page, title first, as pieces. Page and style live as long as these.
std::vector<PdfPiece> pagePieces(const ReportPage& page, const PdfStyle& style) {
    const BlockPieces make(style);
    std::vector<PdfPiece> pieces{
        make.textPiece(page.title, PdfStyle::text(kTitleSize, true), kLightPalette.ink, 0.0),
        make.textPiece(page.subtitle, PdfStyle::text(kTextSize), kLightPalette.muted, 2.0)};
    for (const PageBlock& block : page.content.blocks()) {
        std::ranges::move(std::visit(make, block), std::back_inserter(pieces));
    }
    return pieces;
}

constexpr double kMargin = 15.0;        // [mm]
constexpr double kFooterSize = 7.5;     // [pt]
constexpr double kFooterHeight = 16.0;  // with the room above it [pt]

void drawFooter(QPainter& painter, const PdfStyle& style, const std::string& text, double bottom) {
    const PdfText footer(text,
                         {.font = PdfStyle::text(kFooterSize),
                          .color = colorForQt(kLightPalette.muted),
                          .alignment = Qt::AlignRight},
                         style.width(), style.device());
    footer.draw(painter, {0.0, bottom - footer.height()});
}

}  // namespace

void writePdfPage(const std::filesystem::path& path, const ReportPage& page) {
    const QPageLayout layout(QPageSize(QPageSize::A4), QPageLayout::Portrait,
                             QMarginsF(kMargin, kMargin, kMargin, kMargin),
                             QPageLayout::Millimeter);
    writePdf(path, page.title, layout, [&page](QPdfWriter& writer, QPainter& painter) {
        const PdfStyle style(writer, writer.width());
        const double room = writer.height() - style.points(kFooterHeight);
        const std::vector<PdfPiece> pieces = pagePieces(page, style);
        const auto sheets = onSheets(pieces, room);
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            if (i > 0) {
                writer.newPage();
            }
            for (const auto& [y, piece] : sheets[i]) {
                piece->draw(painter, {0.0, y});
            }
            drawFooter(painter, style,
                       page.title + "  ·  " + std::to_string(i + 1) + " / " +
                           std::to_string(sheets.size()),
                       writer.height());
        }
    });
}

}  // namespace asperity
