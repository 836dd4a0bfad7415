#pragma once

#include "app/exports/ExportView.h"
#include "app/session/ExportMoment.h"
#include "core/Progress.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace asperity {

/// A file that is to be written.
struct ExportOrder {
    ExportSubject subject = ExportSubject::View;
    QString format;  ///< extension without its dot
    PictureSpec spec;
    std::filesystem::path path;
};

/// The view that a subject is written as: the window's pictures as the large view, and so is what
/// is no view.
[[nodiscard]] ExportView viewOf(ExportSubject subject);

/// For a thread in the background. @throw Error; Canceled
using ExportWork = std::function<void(Progress& progress)>;

/// Writes a picture that is drawn.
[[nodiscard]] ExportWork pictureWork(const ExportOrder& order, RasterImage image);
/// Draws and writes what needs no OpenGL: a plot, the deformed surface, the surface at rest.
[[nodiscard]] ExportWork dataWork(const ExportOrder& order,
                                  std::shared_ptr<const ExportMoment> moment);

}  // namespace asperity
