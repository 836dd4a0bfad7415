#pragma once

#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <string>
#include <vector>

class vtkContext2D;

namespace asperity {

/// Place in a picture, from its lower-left corner [pixel].
struct PixelPoint {
    double x = 0.0;
    double y = 0.0;
};

struct PixelRect {
    double left = 0.0;
    double bottom = 0.0;
    double width = 0.0;
    double height = 0.0;

    [[nodiscard]] double right() const { return left + width; }
    [[nodiscard]] double top() const { return bottom + height; }
    [[nodiscard]] bool overlaps(const PixelRect& other) const {
        return left < other.right() && other.left < right() && bottom < other.top() &&
               other.bottom < top();
    }
};

enum class Align : std::uint8_t { Left, Center, Right };

struct TextStyle {
    double size = 17.0;  ///< height of the font [pixel]
    bool bold = false;
    Color color = kLightPalette.ink;
    Align align = Align::Left;
};

struct LineStyle {
    Color color = kLightPalette.ink;
    double width = 1.5;  ///< [pixel]
    bool dashed = false;
};

/// Draws flat shapes and text over a picture, in its pixels whatever the oversampling.
class Painter {
public:
    Painter(vtkContext2D* context, double oversampling) : context_(context), scale_(oversampling) {}

    void line(const std::vector<PixelPoint>& points, const LineStyle& style);
    void fill(const PixelRect& rect, const Color& color, double opacity = 1.0);
    void disc(const PixelPoint& center, double radius, const Color& color);

    /// Pixels stretched over a rectangle, each a rectangle of its own.
    void image(const PixelRect& rect, const RasterImage& image);

    /// Text with its middle height at `at.y`.
    void text(const PixelPoint& at, const std::string& text, const TextStyle& style);
    /// Text that reads upwards, centerd at `at`.
    void upright(const PixelPoint& at, const std::string& text, const TextStyle& style);
    /// Text on a plate, readable over anything; the whole plate stays inside `bounds`.
    void label(const PixelPoint& at, const std::string& text, const TextStyle& style,
               const PixelRect& bounds, const Color& plateColor = kLightPalette.paper);
    [[nodiscard]] double textWidth(const std::string& text, const TextStyle& style);

    /// Words wrapped into the rectangle from its top; the font shrinks until all lines fit.
    void paragraph(const PixelRect& area, const std::string& text, TextStyle style);

private:
    void useText(const TextStyle& style);
    [[nodiscard]] std::vector<std::string> wrapped(const std::string& text, double width,
                                                   const TextStyle& style);

    vtkContext2D* context_;
    double scale_;
};

}  // namespace asperity
