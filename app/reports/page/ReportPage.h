#pragma once

#include "app/charts/Chart.h"
#include "app/charts/ChartPage.h"

#include <filesystem>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace asperity {

// The content of a page, once for all writers. Texts are UTF-8 and may hold anything: writers
// escape them and show control characters as printable() does.

/// Opens a section.
struct PageHeading {
    std::string text;
};

enum class PageTone {
    Plain,
    Caution,  ///< a result holds with a reservation
    Fault,    ///< a result does not hold
};

struct PageParagraph {
    std::string text;
    PageTone tone = PageTone::Plain;
};

/// Sentences, one below the other.
struct PageList {
    std::vector<std::string> items;
};

/// Lines to copy: commands, hashes.
struct PageCode {
    std::vector<std::string> lines;
};

struct PageColumn {
    std::string title;
    bool isNumber = false;  ///< aligned to the right
};

struct PageCell {
    std::string text;
    std::string page = {};  ///< name of the page that it leads to; empty: none
};

/// A table whose columns have titles, or with none of them a list of names and values.
struct PageTable {
    std::vector<PageColumn> columns;
    std::vector<std::vector<PageCell>> rows;  ///< of as many cells as there are columns
    bool hasTitles = true;
};

struct PagePicture {
    std::string png;          ///< the bytes of the file
    std::string description;  ///< for those who do not see it
    std::string caption;
};

struct PagePlot {
    Chart chart;
    std::string description;  ///< for those who do not see it
    std::string caption;
};

using PageBlock =
    std::variant<PageHeading, PageParagraph, PageList, PageCode, PageTable, PagePicture, PagePlot>;

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

/// Returns the plot of a block as all writers draw it.
[[nodiscard]] ChartPage laidOut(const PagePlot& plot);

/// A page of a report, as all of its writers show it.
struct ReportPage {
    std::string name;      ///< of its files, without suffix, see PageNames
    std::string title;     ///< also of the document
    std::string subtitle;  ///< one line
    std::string parent;    ///< name of the page that lists this one; empty: none
    PageContent content;
};

/// The page as one file that needs no other: HTML that is XML, too, pictures and style in it. Light
/// or dark as the reader's system is, light on paper. Links lead to files beside it.
[[nodiscard]] std::string htmlPage(const ReportPage& page);

/// Writes the page as PDF: A4 sheets, text that can be selected and searched, fonts and pictures in
/// it, plots as vectors. No table row and no picture is cut; the titles of a table are above each
/// of its parts. Links lead to files beside it. There is a QGuiApplication.
/// @throw Error when it cannot be written
void writePdfPage(const std::filesystem::path& path, const ReportPage& page);

/// Gives pages names of files, without suffix, that differ on every file system, also where it
/// takes large and small letters as the same.
class PageNames {
public:
    /// @param reserved a name that no page gets
    explicit PageNames(const std::string& reserved) { taken_.insert(reserved); }

    /// A name like that of the folder: "run", then "run_2". Letters, digits, '.', '-' and '_' stay.
    [[nodiscard]] std::string nameFor(const std::filesystem::path& folder);

private:
    std::set<std::string> taken_;  ///< in small letters
};

}  // namespace asperity
