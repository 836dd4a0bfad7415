#include "vtkplugins/pictures/Painter.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

namespace asperity {

namespace {

constexpr double kLineHeight = 1.35;  // of the font's size
constexpr double kMinFont = 9.0;      // [pixel]
constexpr unsigned char kPlateOpacity = 215;

/// Of Debian's package fonts-dejavu-core.
const std::string kLetters = "/usr/share/fonts/truetype/dejavu/DejaVuSans";

/// The typeface of the window, plots and reports; VTK's own where it is not installed.
void useLetters(vtkTextProperty& property, bool isBold) {
    static const bool isInstalled = std::filesystem::exists(kLetters + ".ttf") &&
                                    std::filesystem::exists(kLetters + "-Bold.ttf");
    if (!isInstalled) {
        property.SetFontFamilyToArial();
        return;
    }
    property.SetFontFamily(VTK_FONT_FILE);
    property.SetFontFile((kLetters + (isBold ? "-Bold.ttf" : ".ttf")).c_str());
}

}  // namespace

void Painter::line(const std::vector<PixelPoint>& points, const LineStyle& style) {
    vtkPen* pen = context_->GetPen();
    pen->SetColor(style.color.red, style.color.green, style.color.blue, 255);
    pen->SetWidth(static_cast<float>(style.width * scale_));
    pen->SetLineType(vtkPen::SOLID_LINE);
    std::vector<float> flat;
    for (const PixelPoint& point : points) {
        flat.push_back(static_cast<float>(point.x * scale_));
        flat.push_back(static_cast<float>(point.y * scale_));
    }
    context_->DrawPoly(flat.data(), static_cast<int>(points.size()));
}

void Painter::fill(const PixelRect& rect, const Color& color, double opacity) {
    context_->GetPen()->SetLineType(vtkPen::NO_PEN);
    context_->GetBrush()->SetColor(color.red, color.green, color.blue,
                                   static_cast<unsigned char>(std::lround(255.0 * opacity)));
    context_->DrawRect(
        static_cast<float>(rect.left * scale_), static_cast<float>(rect.bottom * scale_),
        static_cast<float>(rect.width * scale_), static_cast<float>(rect.height * scale_));
}

void Painter::disc(const PixelPoint& center, double radius, const Color& color) {
    context_->GetPen()->SetLineType(vtkPen::NO_PEN);
    context_->GetBrush()->SetColor(color.red, color.green, color.blue, 255);
    context_->DrawEllipse(static_cast<float>(center.x * scale_),
                          static_cast<float>(center.y * scale_),
                          static_cast<float>(radius * scale_), static_cast<float>(radius * scale_));
}

// Enlarged here, pixel by pixel as it is drawn: the texture would blur the pixels into each other.
void Painter::image(const PixelRect& rect, const RasterImage& image) {
    const int width = std::max(1, static_cast<int>(std::lround(rect.width * scale_)));
    const int height = std::max(1, static_cast<int>(std::lround(rect.height * scale_)));
    vtkNew<vtkImageData> drawn;
    drawn->SetDimensions(width, height, 1);
    drawn->AllocateScalars(VTK_UNSIGNED_CHAR, RasterImage::kChannels);
    for (int up = 0; up < height; ++up) {
        const std::uint8_t* row = image.row(image.height - 1 - up * image.height / height);
        auto* target = static_cast<unsigned char*>(drawn->GetScalarPointer(0, up, 0));
        for (int column = 0; column < width; ++column) {
            const std::uint8_t* pixel =
                row +
                static_cast<std::ptrdiff_t>(column * image.width / width) * RasterImage::kChannels;
            target = std::copy_n(pixel, RasterImage::kChannels, target);
        }
    }
    context_->DrawImage(vtkRectf(static_cast<float>(rect.left * scale_),
                                 static_cast<float>(rect.bottom * scale_),
                                 static_cast<float>(width), static_cast<float>(height)),
                        drawn);
}

void Painter::useText(const TextStyle& style) {
    vtkTextProperty* property = context_->GetTextProp();
    useLetters(*property, style.bold);
    property->SetFontSize(static_cast<int>(std::lround(style.size * scale_)));
    property->SetBold(style.bold ? 1 : 0);
    property->SetItalic(0);
    property->SetOrientation(0.0);
    property->SetColor(style.color.fractions().data());
    property->SetOpacity(1.0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToCentered();
}

double Painter::textWidth(const std::string& text, const TextStyle& style) {
    useText(style);
    std::array<float, 4> bounds{};
    context_->ComputeStringBounds(text.c_str(), bounds.data());
    return bounds[2] / scale_;
}

void Painter::text(const PixelPoint& at, const std::string& text, const TextStyle& style) {
    double left = at.x;
    if (style.align != Align::Left) {
        left -= textWidth(text, style) * (style.align == Align::Center ? 0.5 : 1.0);
    }
    useText(style);
    context_->DrawString(static_cast<float>(std::round(left * scale_)),
                         static_cast<float>(std::round(at.y * scale_)), text.c_str());
}

void Painter::label(const PixelPoint& at, const std::string& text, const TextStyle& style,
                    const PixelRect& bounds, const Color& plateColor) {
    const double width = textWidth(text, style) + style.size;
    const double height = style.size * 1.5;
    const double anchor = style.align == Align::Left     ? 0.0
                          : style.align == Align::Center ? 0.5
                                                         : 1.0;
    PixelRect plate{at.x - anchor * width, at.y - 0.5 * height, width, height};
    plate.left = std::max(bounds.left, std::min(plate.left, bounds.right() - width));
    plate.bottom = std::max(bounds.bottom, std::min(plate.bottom, bounds.top() - height));
    fill(plate, plateColor, kPlateOpacity / 255.0);
    TextStyle inside = style;
    inside.align = Align::Left;
    this->text({plate.left + 0.5 * style.size, plate.bottom + 0.5 * height}, text, inside);
}

std::vector<std::string> Painter::wrapped(const std::string& text, double width,
                                          const TextStyle& style) {
    std::vector<std::string> lines;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::istringstream words(paragraph);
        std::string line;
        for (std::string word; words >> word;) {
            std::string longer = line;
            longer.append(line.empty() ? "" : " ").append(word);
            if (!line.empty() && textWidth(longer, style) > width) {
                lines.push_back(line);
                line = word;
            } else {
                line = longer;
            }
        }
        lines.push_back(line);
    }
    return lines;
}

void Painter::paragraph(const PixelRect& area, const std::string& text, TextStyle style) {
    const auto fits = [&](const std::vector<std::string>& lines) {
        return static_cast<double>(lines.size()) * style.size * kLineHeight <= area.height &&
               std::all_of(lines.begin(), lines.end(), [&](const std::string& line) {
                   return textWidth(line, style) <= area.width;
               });
    };
    std::vector<std::string> lines = wrapped(text, area.width, style);
    while (!fits(lines) && style.size > kMinFont) {
        style.size -= 1.0;
        lines = wrapped(text, area.width, style);
    }
    const double left = style.align == Align::Left     ? area.left
                        : style.align == Align::Center ? area.left + 0.5 * area.width
                                                       : area.right();
    double middle = area.top() - 0.5 * style.size * kLineHeight;
    for (const std::string& line : lines) {
        this->text({left, middle}, line, style);
        middle -= style.size * kLineHeight;
    }
}

vtkStandardNewMacro(PainterItem)

bool PainterItem::Paint(vtkContext2D* context) {
    Painter painter(context, oversampling_);
    draw_(painter);
    return true;
}

void PainterItem::setDraw(std::function<void(Painter&)> draw, double oversampling) {
    draw_ = std::move(draw);
    oversampling_ = oversampling;
    Modified();
}

}  // namespace asperity
