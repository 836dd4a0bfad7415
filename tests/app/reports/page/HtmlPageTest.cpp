#include "app/reports/page/ReportPage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <pugixml.hpp>
#include <string>

namespace asperity {
namespace {

const char* const kHostile = "</td><script>alert('x')</script>&\"\x01\xff ]]> --> \xEF\xBF\xBF";

/// One of each kind of block, with this text wherever there is one.
ReportPage pageWith(const std::string& text) {
    ReportPage page{
        .name = "a b%#?", .title = text, .subtitle = text, .parent = "index", .content = {}};
    page.content.addHeading(text);
    page.content.addParagraph(text, PageTone::Fault);
    page.content.addList({text, "second"});
    page.content.addCode({text, "second"});
    page.content.addTable(
        {.columns = {{text}, {"number", true}}, .rows = {{{text, text}, {text}}}});
    page.content.addTable(
        {.columns = {{text}, {text}}, .rows = {{{text}, {text}}}, .hasTitles = false});
    page.content.addPicture({"\x89PNG", text, text});
    page.content.addPlot(
        {.chart = {.title = text,
                   .xLabel = text,
                   .yLabel = text,
                   .curves = {{.label = text, .x = {0.0, 1e-9}, .y = {0.0, 2e-9}},
                              {.label = text, .x = {0.5e-9}, .y = {1e-9}, .rings = true}}},
         .description = text,
         .caption = text});
    return page;
}

/// Returns whether it is XML; then `parsed` holds it.
bool isXml(const std::string& html, pugi::xml_document& parsed) {
    const pugi::xml_parse_result result = parsed.load_string(html.c_str());
    EXPECT_TRUE(result) << result.description() << " at "
                        << html.substr(static_cast<std::size_t>(
                                           std::max<std::ptrdiff_t>(0, result.offset - 50)),
                                       100);
    return static_cast<bool>(result);
}

std::size_t countOf(const pugi::xml_document& page, const char* path) {
    return page.select_nodes(path).size();
}

TEST(HtmlPage, ShowsHostileTextAndDoesNotObeyIt) {
    pugi::xml_document page;
    const std::string html = htmlPage(pageWith(kHostile));
    ASSERT_TRUE(isXml(html, page));
    EXPECT_EQ(countOf(page, "//script"), 0U);
    const std::string shown = "</td><script>alert('x')</script>&\"\\x01\\xff ]]> --> \xEF\xBF\xBD";
    EXPECT_EQ(page.select_node("//title").node().text().get(), shown);
    EXPECT_EQ(page.select_node("//h2").node().text().get(), shown);
    EXPECT_EQ(page.select_node("//img/@alt").attribute().value(), shown);
    EXPECT_EQ(page.select_node("//*[name()='svg']/@aria-label").attribute().value(), shown);
}

TEST(HtmlPage, HasEachBlockOnce) {
    pugi::xml_document page;
    ASSERT_TRUE(isXml(htmlPage(pageWith("text")), page));
    for (const char* path : {"//h1", "//h2", "//p[@class='fault']", "//ul", "//pre", "//thead",
                             "//figure/img", "//figure/*[name()='svg']"}) {
        EXPECT_EQ(countOf(page, path), 1U) << path;
    }
    EXPECT_EQ(countOf(page, "//table"), 2U);
    EXPECT_EQ(countOf(page, "//li"), 2U);
    EXPECT_STREQ(page.select_node("//pre").node().text().get(), "text\nsecond");
    EXPECT_EQ(countOf(page, "//td[@class='number']"), 1U);
    EXPECT_EQ(countOf(page, "//th[@scope='row']"), 1U);
}

TEST(HtmlPage, NeedsNoOtherFileAndLeadsToThoseBesideIt) {
    pugi::xml_document page;
    ASSERT_TRUE(isXml(htmlPage(pageWith("text")), page));
    EXPECT_STREQ(page.select_node("//img/@src").attribute().value(),
                 "data:image/png;base64,iVBORw==");
    EXPECT_EQ(countOf(page, "//link") + countOf(page, "//script"), 0U);
    const auto links = page.select_nodes("//a/@href");
    ASSERT_EQ(links.size(), 3U);
    EXPECT_STREQ(links[0].attribute().value(), "./index.html");
    EXPECT_STREQ(links[1].attribute().value(), "./a%20b%25%23%3F.pdf");
    EXPECT_STREQ(links[2].attribute().value(), "./text.html");
}

TEST(HtmlPage, IsTheSameForTheSameContent) {
    EXPECT_EQ(htmlPage(pageWith("text")), htmlPage(pageWith("text")));
}

}  // namespace
}  // namespace asperity
