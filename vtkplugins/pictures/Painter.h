#pragma once

#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <vtkContextItem.h>

#include <functional>
#include <string>
#include <vector>

class vtkContext2D;

namespace asperity {

/// Position in a picture, from its lower-left corner [pixel].
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

/// Lets a function paint over a view, every time that the view is drawn.
class PainterItem : public vtkContextItem {
public:
    static PainterItem* New();
    PainterItem(const PainterItem&) = delete;
    void operator=(const PainterItem&) = delete;
    vtkTypeMacro(PainterItem, vtkContextItem)

    bool Paint(vtkContext2D* context) override;

    /// @param oversampling drawn pixels per pixel of the painter, along each side
    void setDraw(std::function<void(Painter&)> draw, double oversampling);

protected:
    PainterItem() = default;
    ~PainterItem() override = default;

private:
    std::function<void(Painter&)> draw_;
    double oversampling_ = 1.0;
};

}  // namespace asperity
