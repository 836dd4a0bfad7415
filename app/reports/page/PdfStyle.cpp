#include "app/reports/page/PdfStyle.h"

#include "vtkplugins/pictures/Color.h"

#include <QPaintDevice>

namespace asperity {

namespace {

constexpr double kPointsPerInch = 72.0;

QFont fontOf(const char* family, double size) {
    QFont font(QString::fromLatin1(family));
    font.setPointSizeF(size);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Any spacing at all keeps Qt from ligatures: a reader who copies "film" gets four letters.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64.0);
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

QColor colorForQt(const Color& color) { return {color.red, color.green, color.blue}; }

}  // namespace asperity
