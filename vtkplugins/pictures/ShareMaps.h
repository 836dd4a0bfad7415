#pragma once

#include "vtkplugins/pictures/Color.h"
#include "vtkplugins/pictures/PictureSize.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// A table of cells, each divided into colored shares of its height.
struct ShareMap {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<std::string> columns;  ///< names, from the left
    std::vector<std::string> rows;     ///< names, from below
    /// By row, then column: a share >= 0 for each key, of whatever total; none: an empty cell.
    std::vector<std::vector<double>> cells;
};

/// What a color means.
struct ShareKey {
    Color color;
    std::string text;
};

/// Maps row by row on one page under a common legend.
struct ShareMapPage {
    std::string title;
    std::vector<ShareKey> keys;
    std::vector<ShareMap> maps;
    int mapsPerRow = 1;
};

/// Draws the page. The same page gives the same bytes.
/// @throw Error when a map has another number of cells than rows times columns, no display answers,
///        or the file cannot be written
void writeShareMaps(const std::filesystem::path& path, const ShareMapPage& page,
                    PictureSize size = {});

}  // namespace asperity
