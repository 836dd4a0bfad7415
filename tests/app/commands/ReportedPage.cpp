#include "tests/app/commands/ReportedPage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace asperity::test {

namespace {

constexpr std::string_view kNoBreak = "\u00A0";

std::string withUsualSpaces(std::string text) {
    for (std::size_t at = text.find(kNoBreak); at != std::string::npos; at = text.find(kNoBreak)) {
        text.replace(at, kNoBreak.size(), " ");
    }
    return text;
}

std::string textBelow(const pugi::xml_node& node) {
    std::string text = node.value();
    for (const pugi::xml_node& child : node.children()) {
        text += textBelow(child);
    }
    return node.name() == std::string_view("td") ? text + " " : text;
}

double half(const std::string& number) {
    const std::size_t point = number.find('.');
    const auto decimals =
        point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
    return 0.5 * std::pow(10.0, -decimals);
}

double factorOf(const std::string& unit) {
    for (const auto& [prefix, factor] : {std::pair("a", 1e-18),
                                         {"f", 1e-15},
                                         {"p", 1e-12},
                                         {"n", 1e-9},
                                         {"µ", 1e-6},
                                         {"m", 1e-3},
                                         {"k", 1e3}}) {
        const std::string_view bare =
            std::string_view(unit).substr(std::min(unit.size(), std::string_view(prefix).size()));
        if (unit.starts_with(prefix) &&
            (bare == "N" || bare == "m" || bare == "J" || bare == "N/m")) {
            return factor;
        }
    }
    return 1.0;
}

}  // namespace

ReportedPage::ReportedPage(const std::filesystem::path& html) {
    const pugi::xml_parse_result result = page_.load_file(html.c_str());
    EXPECT_TRUE(result) << html << ": " << result.description();
}

std::string ReportedPage::text() const {
    return withUsualSpaces(textBelow(page_.select_node("//body").node()));
}

pugi::xml_node ReportedPage::titleCell(const std::string& title) const {
    for (const pugi::xpath_node& found : page_.select_nodes("//thead/tr/th")) {
        if (withUsualSpaces(textBelow(found.node())).starts_with(title)) {
            return found.node();
        }
    }
    ADD_FAILURE() << "no column " << title;
    return {};
}

std::vector<std::string> ReportedPage::column(const std::string& title) const {
    const pugi::xml_node head = titleCell(title);
    std::vector<std::string> cells;
    if (!head) {
        return cells;
    }
    std::size_t index = 0;
    for (pugi::xml_node before = head.previous_sibling(); before;
         before = before.previous_sibling()) {
        ++index;
    }
    for (const pugi::xml_node& row :
         head.parent().parent().parent().child("tbody").children("tr")) {
        pugi::xml_node cell = row.first_child();
        for (std::size_t i = 0; i < index; ++i) {
            cell = cell.next_sibling();
        }
        std::string text = withUsualSpaces(textBelow(cell));
        text.erase(text.find_last_not_of(' ') + 1);
        cells.push_back(text);
    }
    return cells;
}

std::string ReportedPage::fact(const std::string& name) const {
    for (const pugi::xpath_node& found : page_.select_nodes("//th[@scope='row']")) {
        if (textBelow(found.node()) == name) {
            std::string text = withUsualSpaces(textBelow(found.node().next_sibling()));
            text.erase(text.find_last_not_of(' ') + 1);
            return text;
        }
    }
    return {};
}

std::vector<std::string> ReportedPage::links() const {
    std::vector<std::string> links;
    for (const pugi::xpath_node& found : page_.select_nodes("//a/@href")) {
        links.emplace_back(found.attribute().value());
    }
    return links;
}

std::size_t ReportedPage::count(const char* xpath) const {
    return page_.select_nodes(xpath).size();
}

double ReportedPage::unitOf(const std::string& title) const {
    const std::string whole = textBelow(titleCell(title));
    const std::size_t open = whole.find('[');
    return open == std::string::npos ? 1.0
                                     : factorOf(whole.substr(open + 1, whole.find(']') - open - 1));
}

std::optional<ShownValue> shownValue(const std::string& cell) {
    if (cell == "–") {
        return std::nullopt;
    }
    const std::size_t sign = cell.find(" ± ");
    const std::string value = cell.substr(0, sign);
    ShownValue shown{.value = std::stod(value), .rounding = half(value), .sigma = {}};
    if (sign != std::string::npos) {
        const std::string after = cell.substr(sign + std::string_view(" ± ").size());
        const std::string sigma = after.substr(0, after.find(' '));
        shown.sigma = std::stod(sigma);
        shown.sigmaRounding = half(sigma);
    }
    return shown;
}

}  // namespace asperity::test
