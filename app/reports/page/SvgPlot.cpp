#include "app/reports/page/SvgPlot.h"

#include "app/reports/page/HtmlPage.h"
#include "app/reports/page/StyleColor.h"
#include "core/FormattedText.h"

namespace asperity {

namespace {

std::string pathOf(const DrawnLine& line) {
    std::string path;
    for (const PlotPoint& point : line.points) {
        path += formatted("%s%.2f %.2f", path.empty() ? "M" : " ", point.x, point.y);
    }
    return path;
}

const char* anchorOf(TextAnchor anchor) {
    switch (anchor) {
    case TextAnchor::Middle:
        return "middle";
    case TextAnchor::End:
        return "end";
    case TextAnchor::Start:
        break;
    }
    return "start";
}

std::string textOf(const DrawnText& text) {
    const std::string turn = text.upward ? formatted(R"x( transform="rotate(-90 %.2f %.2f)")x",
                                                     text.place.x, text.place.y)
                                         : "";
    return formatted(R"(<text class="%s" x="%.2f" y="%.2f" text-anchor="%s")", keyOf(text.ink),
                     text.place.x, text.place.y, anchorOf(text.anchor)) +
           turn + ">" + escaped(text.text) + "</text>\n";
}

}  // namespace

std::string svgPlot(const PlotDrawing& drawing, const std::string& description) {
    std::string svg = formatted(R"(<svg xmlns="http://www.w3.org/2000/svg" role="img" )"
                                R"(viewBox="0 0 %.0f %.0f" font-size="%.1f" aria-label=")",
                                drawing.width, drawing.height, PlotDrawing::kTextSize) +
                      escaped(description) + "\">\n";
    for (const DrawnLine& line : drawing.lines) {
        svg +=
            formatted(R"(<path class="%s" stroke-width="%.2f" d=")", keyOf(line.ink), line.width) +
            pathOf(line) + "\"/>\n";
    }
    for (const DrawnRing& ring : drawing.rings) {
        svg += formatted("<circle class=\"%s\" stroke-width=\"%.2f\" cx=\"%.2f\" cy=\"%.2f\" "
                         "r=\"%.2f\"/>\n",
                         keyOf(ring.ink), PlotDrawing::kRingWidth, ring.place.x, ring.place.y,
                         PlotDrawing::kRingRadius);
    }
    for (const DrawnText& text : drawing.texts) {
        svg += textOf(text);
    }
    return svg + "</svg>\n";
}

std::string svgStyle(const Palette& colors) {
    std::string style;
    for (const PlotInkRow& row : kEnumTable<PlotInk>) {
        const std::string color = styleColor(colors.*row.color);
        style += formatted("svg path.%s,svg circle.%s{fill:none;stroke:%s}\n", row.key, row.key,
                           color.c_str());
        style += formatted("svg text.%s{fill:%s}\n", row.key, color.c_str());
    }
    return style;
}

}  // namespace asperity
