#pragma once

#include "app/exports/ExportView.h"
#include "app/exports/SpatialLook.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace asperity {

/// Options of commands that draw, as they were given.
struct PictureOptions {
    std::string view = keyOf(ExportView::Spatial);
    std::string size;    ///< WxH [pixel]; empty: the usual one, or as `column` says
    std::string column;  ///< of a journal; empty: none
    double aspect = 4.0 / 3.0;
    double dpi = 0.0;  ///< 0: the usual one [dots an inch]
    bool transparent = false;
    bool noBars = false;
    bool noLabels = false;
    bool clean = false;
    double width = 0.0;        ///< of the frame; 0: the usual one [m]
    double heightScale = 0.0;  ///< 0: the usual one
};

void addPictureOptions(CLI::App& command, PictureOptions& options);

/// @throw CLI::ValidationError where the view is none
[[nodiscard]] ExportView viewOf(const PictureOptions& options);
/// @throw CLI::ValidationError where the size is none
[[nodiscard]] PictureSpec specOf(const PictureOptions& options);

}  // namespace asperity
