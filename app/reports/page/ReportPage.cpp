#include "app/reports/page/ReportPage.h"

#include "app/charts/ChartFile.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/io/Base64.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

/// For both palettes.
constexpr const char* kShapes = R"(*{box-sizing:border-box}
body{margin:0 auto;max-width:60rem;padding:1.5rem;font:15px/1.45 "DejaVu Sans",Verdana,sans-serif}
h1{font-size:1.6rem;margin:0}
h2{font-size:1.15rem;margin:2rem 0 .5rem;border-bottom:1px solid;padding-bottom:.2rem}
nav{font-size:.85rem;margin-bottom:1rem}
nav a{margin-right:1.2rem}
p{margin:.5rem 0}
p.caution,p.fault{padding:.5rem .8rem;border-left:4px solid}
ul{margin:.5rem 0;padding-left:1.3rem}
li{margin:.2rem 0;overflow-wrap:anywhere}
.table{overflow-x:auto}
table{border-collapse:collapse;font-size:.87rem;margin:.5rem 0}
th,td{padding:.25rem .7rem .25rem 0;text-align:left;vertical-align:top;border-bottom:1px solid}
th{vertical-align:bottom}
td{overflow-wrap:break-word;max-width:34rem}
.number{text-align:right;font-variant-numeric:tabular-nums}
td.number{white-space:nowrap}
pre{padding:.6rem .8rem;overflow-x:auto;font:13px/1.4 "DejaVu Sans Mono",monospace}
figure{margin:1rem 0}
figure img,figure svg{display:block;width:100%;height:auto;max-width:50rem}
figcaption{font-size:.85rem;margin-top:.3rem}
@media print{body{max-width:none;padding:0;font-size:10pt}nav{display:none}
h2,figcaption{break-after:avoid}figure,tr,p,li{break-inside:avoid}thead{display:table-header-group}
pre{white-space:pre-wrap;overflow-wrap:anywhere}figure img,figure svg{max-width:15cm}
.table{overflow:visible}table{font-size:7.5pt}th,td{padding-right:.35rem}td.number{white-space:normal}}
)";

std::string colorRules(const Palette& colors) {
    const auto color = [](const char* name, const Color& value) {
        return std::string(name) + ":" + styleColor(value);
    };
    return "html,body{" + color("background", colors.paper) + ";" + color("color", colors.ink) +
           "}\na{" + color("color", colors.accent) + "}\nh2,th,td{" +
           color("border-color", colors.faint) + "}\nth,figcaption,.subtitle{" +
           color("color", colors.muted) + "}\npre{" + color("background", colors.window) +
           "}\np.caution{" + color("border-color", colors.caution) + "}\np.fault{" +
           color("border-color", colors.fault) + ";" + color("color", colors.fault) + "}\n";
}

std::string style() {
    return "<style>\n" + std::string(kShapes) + colorRules(kLightPalette) +
           "@media screen and (prefers-color-scheme: dark){\n" + colorRules(kDarkPalette) +
           svgStyle(kDarkPalette) + "}\n</style>\n";
}

/// The file of a page beside this one, as a link has it. Source: RFC 3986, section 2.
std::string fileLink(const std::string& name, const char* suffix) {
    std::string link = "./";  // so that no name is taken for a scheme
    for (const char byte : name + suffix) {
        const auto code = static_cast<unsigned char>(byte);
        const bool isPlain =
            code < 0x80 && (std::isalnum(code) != 0 || byte == '.' || byte == '-' || byte == '_');
        link += isPlain ? std::string(1, byte) : formatted("%%%02X", code);
    }
    return link;
}

std::string linkTo(const std::string& name, const char* suffix, const std::string& text) {
    return "<a href=\"" + fileLink(name, suffix) + "\">" + escaped(text) + "</a>";
}

std::string captionOf(const std::string& caption) {
    return caption.empty() ? "" : "<figcaption>" + escaped(caption) + "</figcaption>";
}

/// Writes each kind of block.
class HtmlBlock {
public:
    std::string operator()(const PageHeading& heading) const {
        return "<h2>" + escaped(heading.text) + "</h2>\n";
    }

    std::string operator()(const PageParagraph& paragraph) const {
        const char* const tone = paragraph.tone == PageTone::Plain     ? ""
                                 : paragraph.tone == PageTone::Caution ? " class=\"caution\""
                                                                       : " class=\"fault\"";
        return "<p" + std::string(tone) + ">" + escaped(paragraph.text) + "</p>\n";
    }

    std::string operator()(const PageList& list) const {
        std::string html;
        for (const std::string& item : list.items) {
            html += "<li>" + escaped(item) + "</li>\n";
        }
        return html.empty() ? html : "<ul>\n" + html + "</ul>\n";
    }

    std::string operator()(const PageCode& code) const {
        std::string html = "<pre>";
        for (const std::string& line : code.lines) {
            html += (&line == code.lines.data() ? "" : "\n") + escaped(line);
        }
        return html + "</pre>\n";
    }

    std::string operator()(const PageTable& table) const {
        std::string html = "<div class=\"table\"><table>\n";
        if (table.hasTitles) {
            html += "<thead><tr>";
            for (const PageColumn& column : table.columns) {
                html += "<th" + classOf(column) + ">" + escaped(column.title) + "</th>";
            }
            html += "</tr></thead>\n";
        }
        html += "<tbody>\n";
        for (const auto& row : table.rows) {
            html += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i) {
                html += cellOf(row[i], table, i);
            }
            html += "</tr>\n";
        }
        return html + "</tbody>\n</table></div>\n";
    }

    std::string operator()(const PagePicture& picture) const {
        return "<figure><img alt=\"" + escaped(picture.description) +
               "\" src=\"data:image/png;base64," + base64(picture.png) + "\"/>" +
               captionOf(picture.caption) + "</figure>\n";
    }

    std::string operator()(const PagePlot& plot) const {
        return "<figure>" + svgOf(laidOut(plot), plot.description) + captionOf(plot.caption) +
               "</figure>\n";
    }

private:
    static std::string classOf(const PageColumn& column) {
        return column.isNumber ? " class=\"number\"" : "";
    }

    static std::string cellOf(const PageCell& cell, const PageTable& table, std::size_t column) {
        const std::string text =
            cell.page.empty() ? escaped(cell.text) : linkTo(cell.page, ".html", cell.text);
        const bool isName = !table.hasTitles && column == 0;
        return isName ? "<th scope=\"row\">" + text + "</th>"
                      : "<td" + classOf(table.columns[column]) + ">" + text + "</td>";
    }
};

std::string navigation(const ReportPage& page) {
    const std::string up =
        page.parent.empty() ? "" : linkTo(page.parent, ".html", "All runs") + " ";
    return "<nav>" + up + linkTo(page.name, ".pdf", "This page as PDF") + "</nav>\n";
}

}  // namespace

void PageContent::addHeading(const std::string& text) { blocks_.emplace_back(PageHeading{text}); }

void PageContent::addParagraph(const std::string& text, PageTone tone) {
    blocks_.emplace_back(PageParagraph{text, tone});
}

void PageContent::addList(const std::vector<std::string>& items) {
    blocks_.emplace_back(PageList{items});
}

void PageContent::addCode(const std::vector<std::string>& lines) {
    blocks_.emplace_back(PageCode{lines});
}

void PageContent::addTable(PageTable table) { blocks_.emplace_back(std::move(table)); }
void PageContent::addPicture(PagePicture picture) { blocks_.emplace_back(std::move(picture)); }
void PageContent::addPlot(PagePlot plot) { blocks_.emplace_back(std::move(plot)); }

ChartPage laidOut(const PagePlot& plot) {
    return layOut(std::span(&plot.chart, 1), {.width = 668.0, .height = 400.0, .letters = 0.95});
}

namespace {

constexpr std::size_t kLongest = 100;  // bytes, so that a file system accepts it with its suffix

bool isKept(const Utf8Character& character) {
    if (character.codePoint >= 0x80) {
        return !isCommand(character.codePoint);
    }
    const int letter = static_cast<int>(character.codePoint);
    return std::isalnum(letter) != 0 || letter == '.' || letter == '-' || letter == '_';
}

std::string fileNameOf(std::string_view text) {
    std::string name;
    while (!text.empty() && name.size() < kLongest) {
        const Utf8Character character = firstCharacter(text);
        const std::size_t length = std::max<std::size_t>(1, character.length);
        if (character.length > 0 && isKept(character)) {
            name += text.substr(0, length);
        } else {
            name += '_';
        }
        text.remove_prefix(length);
    }
    if (name.empty() || name.front() == '.' || name.front() == '-') {
        name.insert(0, "run");  // neither hidden nor an option
    }
    return name;
}

std::string inSmallLetters(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return text;
}

}  // namespace

std::string PageNames::nameFor(const std::filesystem::path& folder) {
    std::error_code unknown;
    std::filesystem::path whole = std::filesystem::absolute(folder, unknown).lexically_normal();
    if (!whole.has_filename()) {
        whole = whole.parent_path();  // "run/"
    }
    const std::string first = fileNameOf(whole.filename().string());
    std::string name = first;
    for (int number = 2; !taken_.insert(inSmallLetters(name)).second; ++number) {
        name = first + "_" + std::to_string(number);
    }
    return name;
}

std::string htmlPage(const ReportPage& page) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
        "<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "img-src data:; style-src 'unsafe-inline'\"/>\n<title>" +
        escaped(page.title) + "</title>\n" + style() + "</head>\n<body>\n" + navigation(page) +
        "<h1>" + escaped(page.title) + "</h1>\n<p class=\"subtitle\">" + escaped(page.subtitle) +
        "</p>\n";
    for (const PageBlock& block : page.content.blocks()) {
        html += std::visit(HtmlBlock(), block);
    }
    return html + "</body>\n</html>\n";
}

}  // namespace asperity
