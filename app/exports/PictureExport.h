#pragma once

#include "app/exports/ExportView.h"
#include "app/exports/PictureFile.h"
#include "app/exports/RunMoment.h"

#include <filesystem>
#include <string>

namespace asperity {

/// One picture of a scene or of a moment of a run.
struct PictureRequest {
    ExportView view = ExportView::Spatial;
    RunMoment moment = NamedMoment::Deepest;  ///< of a run
    PictureSpec spec;
};

/// Refuses what cannot be drawn of an input, before long work is done for it.
/// @throw Error naming what is missing
void requireDrawable(const PictureRequest& request, bool hasRun);

/// Draws and writes it, whole or not at all. A plot with pixels or as PDF needs a QGuiApplication,
/// every other picture with pixels an X display.
/// @throw Error; Canceled
void writeExport(ExportInput& input, const PictureRequest& request,
                 const std::filesystem::path& path, ExportFormat format,
                 Progress* progress = nullptr);

/// Parts from which names of files are made.
struct OutputNameParts {
    std::string file;  ///< of the input
    std::string view;
};

/// A file in a folder, by a name whose placeholders {file}, {view} and {n} are filled in; n counts
/// from 1 to the first name that is free. A name without {n} may be that of a file that is there.
/// @throw Error for another placeholder
[[nodiscard]] std::filesystem::path namedPath(const std::filesystem::path& folder,
                                              const std::string& name,
                                              const OutputNameParts& parts);

/// Returns the path that --out means: placeholders of its last name are filled in as by
/// namedPath(); its folders are as they are. @throw Error for another placeholder
[[nodiscard]] std::filesystem::path filledPath(const std::filesystem::path& out,
                                               const OutputNameParts& parts);

/// Returns the file that --out means. A folder, or a text that ends in '/': a new file of the name
/// {file}_{view}_{n}.png in it; else as filledPath().
/// @throw Error for another placeholder, and where the file is there and nothing may replace it
/// @param force a file of the name may be replaced
[[nodiscard]] std::filesystem::path outputPath(const std::string& out, const OutputNameParts& parts,
                                               bool force);

}  // namespace asperity
