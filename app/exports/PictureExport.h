#pragma once

#include "app/exports/ExportFormat.h"
#include "app/exports/ExportInput.h"
#include "app/exports/RunMoment.h"
#include "app/exports/SpatialLook.h"

#include <filesystem>

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

}  // namespace asperity
