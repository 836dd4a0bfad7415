#pragma once

#include "app/reports/page/PageBlock.h"

#include <string>
#include <vector>

namespace asperity {

/// The content of a page, block by block.
class PageContent {
public:
    void addHeading(const std::string& text);
    void addParagraph(const std::string& text, PageTone tone = PageTone::Plain);
    void addList(const std::vector<std::string>& items);
    void addCode(const std::vector<std::string>& lines);
    void addTable(PageTable table);
    void addPicture(PagePicture picture);
    void addPlot(PagePlot plot);

    [[nodiscard]] const std::vector<PageBlock>& blocks() const noexcept { return blocks_; }

private:
    std::vector<PageBlock> blocks_;
};

/// A page of a report, as all of its writers show it.
struct ReportPage {
    std::string name;      ///< of its files, without suffix, see PageNames
    std::string title;     ///< also of the document
    std::string subtitle;  ///< one line
    std::string parent;    ///< name of the page that lists this one; empty: none
    PageContent content;
};

}  // namespace asperity
