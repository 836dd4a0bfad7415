#pragma once

#include "app/charts/Chart.h"
#include "app/exports/ExportView.h"
#include "app/exports/Film.h"
#include "app/exports/PictureFile.h"
#include "app/window/RunControl.h"
#include "app/window/export/ExportChoices.h"
#include "core/Progress.h"
#include "core/deformation/ContactDeformation.h"
#include "core/surface/deformation/SurfaceDeformation.h"
#include "ui/view/ZoomPicture.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <QObject>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Has the thread that made this object do pieces of the work of another one, each in an event of
/// its own: OpenGL beside the window's is safe on the window's thread alone. It outlives that work.
class MainThreadExecutor {
public:
    /// Called by the other thread, which waits until the piece is done. Work that is canceled waits
    /// no longer, and the piece is left out: this object's thread may be waiting for its end.
    /// @throw what the piece throws; Canceled
    void run(const std::function<void()>& piece, const Progress& progress);
    /// The same without waiting, whatever becomes of the work: to let go of what lives there.
    template <typename Piece>
    void later(Piece piece) {
        QMetaObject::invokeMethod(&here_, std::move(piece), Qt::QueuedConnection);
    }

private:
    QObject here_;
};

/// Views that a film can show, as a dialog offers them.
[[nodiscard]] std::vector<ExportOption> filmViews();
/// Moments between which it can go, by the time at which they come.
[[nodiscard]] std::vector<ExportOption> filmMoments();

/// Returns the film that was chosen. @throw Error where a moment is none
[[nodiscard]] FilmRequest filmRequest(const FilmChoices& choices, const PictureSpec& spec);

/// Makes a film of a recording in the background: a video, or else a folder of pictures, in place
/// of an earlier film. Frames are drawn by the window's thread, one at a time.
/// @param recording folder of a run, or a bundle
/// @throw Error; InputError; Canceled
void filmRecording(const std::filesystem::path& recording, const FilmRequest& request,
                   const std::filesystem::path& out, MainThreadExecutor& executor,
                   Progress& progress);

/// Draws for a thread in the background, but on the window's thread, a piece in an event.
class FilmRenderer : public FilmArtist {
public:
    using Make = std::function<std::unique_ptr<FilmArtist>()>;

    /// @param make called on the window's thread; what it holds lives as long as what it makes
    /// @throw what `make` throws; Canceled
    FilmRenderer(Make make, MainThreadExecutor& executor, const Progress& progress);
    ~FilmRenderer() override;
    FilmRenderer(const FilmRenderer&) = delete;
    FilmRenderer& operator=(const FilmRenderer&) = delete;

    void foresee(const TickSample& sample) override;
    void keepScales() override;
    [[nodiscard]] RasterImage draw(const TickSample& sample, const std::string& caption) override;

private:
    /// Objects that live on the window's thread.
    struct Drawing {
        Make make;
        std::unique_ptr<FilmArtist> artist;
    };

    MainThreadExecutor& executor_;
    const Progress& progress_;
    std::shared_ptr<Drawing> drawing_;
};

class LivePanels;

/// Content of the window at one moment, so that a preview and the file are of the same one. It
/// holds the scene: the run may end before.
struct ExportMoment {
    std::shared_ptr<const LoadedScene> loaded;  ///< whose description may change during export
    std::string name;   ///< of the recording that is open, else of the scan's file, or the shape
    TickSample sample;  ///< that it showed
    PatchGrid patch;    ///< of the surface around the tip
    std::optional<ContactSection> section;  ///< through the contact; none: no tip
    ShownView view;                         ///< of the large view
    std::vector<TickSample> ticks;          ///< the last seconds until then, in order
    Chart cycles;                           ///< the force-distance curves that are drawn
    std::string distance;  ///< over which they are drawn, as a table's column names it
};

/// The present one, or that of a recording that is looked at. The window shows a run, which has
/// ticks.
[[nodiscard]] ExportMoment presentMoment(LivePanels& live, RunControl& runs);

/// Returns the look of the large view in a picture.
[[nodiscard]] OffscreenZoomLook viewLook(const ExportMoment& moment, const PictureSpec& spec);

/// Draws the large view. For the window's thread. @throw Error
[[nodiscard]] RasterImage viewImage(const ExportMoment& moment, const PictureSpec& spec);

/// The charts of one of the plots. @throw Error where there is nothing to draw yet
[[nodiscard]] std::vector<Chart> chartsOf(const ExportMoment& moment, ExportSubject subject);

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

/// Work for a thread in the background. @throw Error; Canceled
using ExportWork = std::function<void(Progress& progress)>;

/// Writes a picture that is drawn.
[[nodiscard]] ExportWork pictureWork(const ExportOrder& order, RasterImage image);
/// Draws and writes what needs no OpenGL: a plot, the deformed surface, the surface at rest.
[[nodiscard]] ExportWork dataWork(const ExportOrder& order,
                                  std::shared_ptr<const ExportMoment> moment);

}  // namespace asperity
