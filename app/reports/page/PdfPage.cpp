#include "app/reports/page/PdfPage.h"

#include "app/reports/page/PdfBlocks.h"
#include "app/reports/page/PdfText.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>

namespace asperity {

namespace {

constexpr int kResolution = 1200;       // [1/inch]: of places, pictures keep their own
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
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(printable(page.title)));
    writer.setCreator(QStringLiteral("Asperity ") + QString::fromLatin1(kVersion));
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMargin, kMargin, kMargin, kMargin), QPageLayout::Millimeter);
    {
        QPainter painter(&writer);
        painter.setRenderHint(QPainter::LosslessImageRendering);
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
    }
    OutputFile file(path);
    file.stream().write(bytes.constData(), bytes.size());
    file.commit();
}

}  // namespace asperity
