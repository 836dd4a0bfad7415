#pragma once

#include "app/reports/page/Plot.h"

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
    Plot plot;
    std::string caption;
};

using PageBlock =
    std::variant<PageHeading, PageParagraph, PageList, PageCode, PageTable, PagePicture, PagePlot>;

}  // namespace asperity
