#include "app/reports/page/ReportPage.h"

#include <utility>

namespace asperity {

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

}  // namespace asperity
