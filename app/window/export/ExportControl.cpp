#include "app/window/export/ExportControl.h"

#include "app/exports/PictureExport.h"
#include "app/exports/PictureFile.h"
#include "app/exports/RunMoment.h"
#include "app/exports/SurfaceFile.h"
#include "app/exports/VideoFile.h"
#include "app/runs/RunFolder.h"
#include "app/window/export/ExportChoices.h"
#include "app/window/export/FilmOfRecording.h"
#include "app/window/live/LivePanels.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "ui/plot/CopyablePlot.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/Menus.h"
#include "ui/shell/RunPanel.h"
#include "ui/view/SecondView.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCursor>
#include <QFile>
#include <QImage>
#include <QPixmap>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kPreviewDelay = 150;  // that choices rest before they are drawn [ms]
constexpr int kMinSide = 32;        // of a preview [pixel]

std::string bytesOf(const QString& text) { return QFile::encodeName(text).toStdString(); }

OfferedFormat offered(const std::string& extension, bool isSized) {
    return {.key = QString::fromStdString(extension.substr(1)), .isSized = isSized};
}

/// Those of its view; what the dialog draws no picture of is written as data alone.
std::vector<OfferedFormat> viewFormats(ExportSubject subject) {
    std::vector<OfferedFormat> formats;
    for (const ExportFormat format : formatsOf(viewOf(subject))) {
        if (isPicture(subject) || !isDrawn(format)) {
            formats.push_back({.key = QString::fromLatin1(keyOf(format)),
                               .isSized = isDrawn(format) && subject != ExportSubject::Window});
        }
    }
    return formats;
}

ExportOffer offer() {
    ExportOffer offer{
        .formats = {}, .columns = {}, .filmViews = filmViews(), .moments = filmMoments()};
    for (const ExportSubject subject :
         {ExportSubject::View, ExportSubject::Window, ExportSubject::Forces, ExportSubject::Cycle,
          ExportSubject::Deformation}) {
        offer.formats[subject] = viewFormats(subject);
    }
    offer.formats[ExportSubject::Section] = {offered(".csv", false)};
    for (const std::string& extension : surfaceExtensions()) {
        offer.formats[ExportSubject::Surface].push_back(offered(extension, false));
    }
    std::vector<OfferedFormat>& film = offer.formats[ExportSubject::Film];
    film.push_back({.key = QStringLiteral("frames"), .isSized = true});
    if (haveVideoEncoder()) {
        for (const std::string& extension : videoExtensions()) {
            film.push_back(offered(extension, true));
        }
    }
    for (const JournalColumn& column : journalColumns()) {
        offer.columns.push_back({QString::fromLatin1(column.name), column.width});
    }
    return offer;
}

QString standardFolder() {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return (pictures.isEmpty() ? QStringLiteral(".") : pictures) + QStringLiteral("/Asperity");
}

/// @throw Error where a film of this cannot be made
void requireFilm(const FilmChoices& choices) {
    (void)filmRequest(choices, {});
    if (!holdsRun(bytesOf(choices.recording))) {
        throw Error("Choose the recording: the folder of a run, or a bundle.");
    }
}

/// A picture that takes longer than a frame says so.
class WaitCursor {
public:
    WaitCursor() { QApplication::setOverrideCursor(Qt::WaitCursor); }
    ~WaitCursor() { QApplication::restoreOverrideCursor(); }
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

}  // namespace

ExportControl::ExportControl(Stage& stage)
    : Feature(stage)
    , views_(stage.get<ViewControl>())
    , preview_({.progressed = [](double) {},
                .finished = [this](QImage& picture) { showPicture(picture); },
                .failed =
                    [this](const std::exception_ptr& reason) {
                        pictureFailure_ = reasonOf(reason);
                        if (dialog_ != nullptr) {
                            dialog_->showWords({});
                        }
                        showFailures();
                    }})
    , work_(loadingLine(host_), {.finished = [this](QString& told) { host_.tell(told); },
                                 .failed =
                                     [this](const std::exception_ptr& reason) {
                                         host_.tell(reasonOf(reason), MessageKind::Error);
                                     }}) {
    soon_.setSingleShot(true);
    soon_.setInterval(kPreviewDelay);
    connect(&soon_, &QTimer::timeout, this, &ExportControl::preview);
    const QAction& entry =
        host_.menus().add({MenuName::File, 1, 20}, "exportView",
                          {.text = tr("E&xport…"),
                           .tip = tr("Write a view, a plot, a field, the surface or a film, as "
                                     "you choose"),
                           .shortcuts = {tr("Ctrl+E")},
                           .refusal = [this] { return runs_.showRefusal(); }});
    connect(&entry, &QAction::triggered, this, &ExportControl::ask);
}

void ExportControl::remember(std::unique_ptr<QSettings> settings) {
    settings_ = std::move(settings);
    choices_ = keptChoices(*settings_);
}

void ExportControl::ask() {
    if (dialog_ != nullptr || runs_.run() == nullptr) {
        return;
    }
    if (work_.isAwaited()) {  // another one would replace it
        host_.tell(tr("A file is being written still: wait for it, or cancel it"));
        return;
    }
    runs_.fetch();
    if (!runs_.showsRecording() && runs_.run()->loop().snapshot().statistics.ticks == 0) {
        host_.tell(tr("There is nothing to export yet: the run has not begun"));
        return;
    }
    moment_ = std::make_shared<const ExportMoment>(presentMoment(live_, runs_));
    windowPicture_ = {};
    previewed_.reset();
    if (choices_.folder.isEmpty()) {
        choices_.folder = standardFolder();
    }
    chooseOpenRecording();
    dialog_ = new ExportDialog(offer(), choices_, &host_.widget());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connectDialog();
    dialog_->open();
    follow();
}

/// A film of another recording is of all of it, at first.
void ExportControl::chooseOpenRecording() {
    const QString open = QFile::decodeName(runs_.openRecording().c_str());
    if (!open.isEmpty() && open != choices_.film.recording) {
        choices_.film.recording = open;
        choices_.film.from = FilmChoices().from;
        choices_.film.to = FilmChoices().to;
    }
}

void ExportControl::connectDialog() {
    connect(dialog_, &ExportDialog::changed, this, &ExportControl::follow);
    connect(dialog_, &ExportDialog::exportRequested, this, &ExportControl::write);
    connect(dialog_, &ExportDialog::copyRequested, this, &ExportControl::copy);
    connect(dialog_, &QDialog::finished, this, [this] {
        choices_ = dialog_->choices();
        if (settings_) {
            keepChoices(*settings_, choices_);
        }
        soon_.stop();
        preview_.cancel();
        moment_.reset();
    });
}

/// The choices are others.
void ExportControl::follow() {
    showFile();
    soon_.start();
}

std::filesystem::path ExportControl::file() const {
    const ExportChoices& choices = dialog_->choices();
    const std::string extension = dialog_->format() == QStringLiteral("frames")
                                      ? std::string()
                                      : "." + dialog_->format().toStdString();
    if (choices.name.trimmed().isEmpty() || choices.folder.trimmed().isEmpty()) {
        throw Error("Give the file a name and a folder.");
    }
    const std::string source = choices.subject == ExportSubject::Film
                                   ? exportName(bytesOf(choices.film.recording))
                                   : moment_->name;
    return namedPath(bytesOf(choices.folder), bytesOf(choices.name) + extension,
                     {source, keyOf(choices.subject)});
}

void ExportControl::showFile() {
    nameFailure_.clear();
    try {
        if (dialog_->choices().subject == ExportSubject::Film) {
            requireFilm(dialog_->choices().film);
        }
        dialog_->showFile(shownPath(file()));
    } catch (const std::exception& error) {
        dialog_->showFile({});
        nameFailure_ = QString::fromStdString(printable(error.what()));
    }
    showFailures();
}

void ExportControl::showFailures() {
    if (dialog_ != nullptr) {
        dialog_->showFailure(nameFailure_.isEmpty() ? pictureFailure_ : nameFailure_);
    }
}

/// None: as the window colors the large view.
std::optional<SurfaceQuantity> ExportControl::color() const {
    const ExportChoices& choices = dialog_->choices();
    if (choices.subject == ExportSubject::Film) {
        return choices.dent ? contactColor() : SurfaceQuantity::Height;
    }
    const bool isContact = moment_->sample.output.region() == TipRegion::Contact;
    return choices.dent && isContact ? std::optional(contactColor()) : std::nullopt;
}

PictureSpec ExportControl::spec() const {
    const ExportChoices& choices = dialog_->choices();
    const bool isVideo =
        choices.subject == ExportSubject::Film && dialog_->format() != QStringLiteral("frames");
    return {.size = {.width = choices.size.width(), .height = choices.size.height()},
            .dpi = static_cast<double>(choices.dpi),
            .transparent = choices.transparent && !isVideo,
            .parts = {.bars = choices.bars && !choices.clean,
                      .labels = choices.labels && !choices.clean,
                      .grid = !choices.clean,
                      .surfaceGrid = !choices.clean},
            .color = color()};
}

/// The same picture with fewer pixels: letters shrink with it.
PictureSpec ExportControl::previewSpec() const {
    PictureSpec small = spec();
    const QSize room = dialog_->previewRoom();
    const double share = std::min({1.0, static_cast<double>(room.width()) / small.size.width,
                                   static_cast<double>(room.height()) / small.size.height});
    const auto shrunk = [share](int side) {
        return std::max(kMinSide, static_cast<int>(std::lround(share * side)));
    };
    small.size = {.width = shrunk(small.size.width), .height = shrunk(small.size.height)};
    small.dpi *= share;
    return small;
}

const QImage& ExportControl::windowPicture() {
    if (windowPicture_.isNull()) {
        windowPicture_ = views_.picture().toImage();
    }
    return windowPicture_;
}

/// Of a subject that has one.
QImage ExportControl::picture(const PictureSpec& spec) {
    const ExportSubject subject = dialog_->choices().subject;
    switch (subject) {
    case ExportSubject::View:
        return imageOf(viewImage(*moment_, spec));
    case ExportSubject::Window:
        return windowPicture();
    default:
        return imageOf(drawnPage(plotPage(chartsOf(*moment_, subject), spec), spec));
    }
}

QString ExportControl::wordsFor(ExportSubject subject) const {
    const BSplineSurface::Grid& grid = moment_->loaded->scene.surface.grid();
    switch (subject) {
    case ExportSubject::Deformation:
        return tr(
            "Points of the deformed surface around the contact, with their undeformed positions, "
            "displacements and normals, in meters.");
    case ExportSubject::Section:
        return tr("The section through the contact: undeformed and deformed surface and outline of "
                  "the tip, as the second view shows them, in meters.");
    case ExportSubject::Surface:
        return tr("The surface that the tip meets, leveled and smoothed: %1 × %2 heights.")
            .arg(grid.columns)
            .arg(grid.rows);
    default:
        return tr("The recording, frame by frame, with a line of readings in each frame.");
    }
}

void ExportControl::preview() {
    if (dialog_ == nullptr) {
        return;
    }
    pictureFailure_.clear();
    preview_.cancel();
    const ExportSubject subject = dialog_->choices().subject;
    if (previewed_ != subject) {  // what is there is a picture of something else
        dialog_->showWords(tr("Drawing …"));
        previewed_ = subject;
    }
    if (!isPicture(subject)) {
        dialog_->showWords(wordsFor(subject));
    } else if (subject == ExportSubject::Window) {
        dialog_->showPreview(windowPicture());
    } else if (subject == ExportSubject::View) {
        preview_.start([this, moment = moment_,
                        look = viewLook(*moment_, previewSpec())](Progress& progress) {
            FilmRenderer artist([moment, look] { return filmArtist(moment->loaded->scene, look); },
                                executor_, progress);
            artist.foresee(moment->sample);
            return imageOf(artist.draw(moment->sample, {}));
        });
    } else {
        preview_.start([moment = moment_, subject, spec = previewSpec()](Progress&) {
            return imageOf(drawnPage(plotPage(chartsOf(*moment, subject), spec), spec));
        });
    }
    showFailures();
}

void ExportControl::showPicture(const QImage& picture) {
    if (dialog_ != nullptr) {
        dialog_->showPreview(picture);
    }
}

/// Nothing is replaced unasked.
void ExportControl::write() {
    showFile();
    if (!nameFailure_.isEmpty()) {
        return;
    }
    const std::filesystem::path path = file();
    if (!isThere(path)) {
        draw(path);
        return;
    }
    askWhether(dialog_, tr("%1 is there already. Replace it?").arg(shownPath(path)), tr("Replace"),
               [this, path] {
                   if (dialog_ != nullptr) {
                       draw(path);
                   }
               });
}

/// A large view stops the window while it is drawn, for so long that a recording would lose ticks.
void ExportControl::draw(const std::filesystem::path& path) {
    constexpr double kSoonDrawn = 8e6;  // [pixel]
    const QSize& size = dialog_->choices().size;
    const bool isLarge = dialog_->choices().subject == ExportSubject::View &&
                         1.0 * size.width() * size.height() > kSoonDrawn;
    if (!isLarge || !runs_.isRecorded()) {
        start(path);
        return;
    }
    askWhether(dialog_,
               tr("The window is blocked while such a large picture is drawn, and the running "
                  "recording may end. Draw it now?"),
               tr("Draw"), [this, path] {
                   if (dialog_ != nullptr) {
                       start(path);
                   }
               });
}

void ExportControl::start(const std::filesystem::path& path) {
    try {
        std::filesystem::create_directories(path.parent_path());
        if (dialog_->format() != QStringLiteral("frames")) {
            requireWritable(path);
        }
        const ExportWork work = workFor({.subject = dialog_->choices().subject,
                                         .format = dialog_->format(),
                                         .spec = spec(),
                                         .path = path});
        dialog_->accept();
        work_.start(tr("Writing %1 …").arg(shownPath(path.filename())),
                    [work, told = tr("Exported to %1").arg(shownPath(path))](Progress& progress) {
                        work(progress);
                        return told;
                    });
    } catch (const std::exception& error) {
        dialog_->showFailure(QString::fromStdString(printable(error.what())));
    }
}

/// What needs the window's thread is done now, or by it piece by piece.
ExportWork ExportControl::workFor(const ExportOrder& order) {
    if (order.subject == ExportSubject::Film) {
        const ExportChoices& choices = dialog_->choices();
        return [this, recording = bytesOf(choices.film.recording),
                request = filmRequest(choices.film, order.spec),
                path = order.path](Progress& progress) {
            filmRecording(recording, request, path, executor_, progress);
        };
    }
    if (order.subject == ExportSubject::View || order.subject == ExportSubject::Window) {
        const WaitCursor busy;
        return pictureWork(order, rasterOf(picture(order.spec)));
    }
    return dataWork(order, moment_);
}

void ExportControl::copy() {
    try {
        const WaitCursor busy;
        QApplication::clipboard()->setImage(picture(spec()));
        host_.tell(tr("The picture is on the clipboard"));
        dialog_->accept();
    } catch (const Error& error) {
        dialog_->showFailure(QString::fromStdString(printable(error.what())));
    }
}

namespace {

/// The plot under the pointer, else the one that has the focus; null: none.
CopyablePlot* meantPlot() {
    if (CopyablePlot* plot = CopyablePlot::of(QApplication::widgetAt(QCursor::pos()))) {
        return plot;
    }
    return CopyablePlot::of(QApplication::focusWidget());
}

}  // namespace

ClipboardControl::ClipboardControl(Stage& stage)
    : Feature(stage), views_(stage.get<ViewControl>()) {
    Menus& menus = host_.menus();
    QAction& view = menus.add({MenuName::Edit, 1, 10}, "copyView",
                              {.text = tr("&Copy view"),
                               .tip = tr("Put the picture of the large view on the clipboard"),
                               .shortcuts = {QKeySequence::Copy}});
    view.setShortcutContext(Qt::WidgetShortcut);  // number fields copy what they hold
    live_.view().addAction(&view);
    live_.second().space().addAction(&view);
    const QAction& whole = menus.add(
        {MenuName::Edit, 1, 20}, "copyWindow",
        {.text = tr("Copy &window"), .tip = tr("Put the picture of the window on the clipboard")});
    plot_ = &menus.add({MenuName::Edit, 1, 30}, "copyPlot",
                       {.text = tr("Copy &plot"),
                        .tip = tr("Put the plot under the pointer on the clipboard, as picture and "
                                  "as numbers"),
                        .shortcuts = {tr("Ctrl+Shift+C")}});
    const QAction& numbers =
        menus.add({MenuName::Edit, 1, 40}, "copyNumbers",
                  {.text = tr("Copy r&eadings"),
                   .tip = tr("Put all numbers shown on the clipboard: tab-separated, with standard "
                             "deviations"),
                   .refusal = [this] { return runs_.showRefusal(); }});
    connect(&view, &QAction::triggered, this, &ClipboardControl::copyView);
    connect(&whole, &QAction::triggered, this, &ClipboardControl::copyWindow);
    connect(plot_, &QAction::triggered, this, &ClipboardControl::copyPlot);
    connect(&numbers, &QAction::triggered, this, &ClipboardControl::copyNumbers);
}

void ClipboardControl::copyView() {
    // The picture of the second view where that has the focus.
    auto* const focused = qobject_cast<ZoomView*>(QApplication::focusWidget());
    ZoomView& view = focused != nullptr ? *focused : live_.view();
    QApplication::clipboard()->setImage(view.grab().toImage());
    host_.tell(tr("The view is on the clipboard"));
}

void ClipboardControl::copyWindow() {
    QApplication::clipboard()->setImage(views_.picture().toImage());
    host_.tell(tr("The window is on the clipboard"));
}

void ClipboardControl::copyPlot() {
    const CopyablePlot* const plot = meantPlot();
    if (plot == nullptr) {
        host_.tell(tr("Which plot? Point at one and press %1, or use its context menu")
                       .arg(plot_->shortcut().toString(QKeySequence::NativeText)));
        return;
    }
    plot->copy();
    host_.tell(tr("The plot is on the clipboard"));
}

void ClipboardControl::copyNumbers() {
    if (runs_.run() == nullptr) {
        return;
    }
    const Snapshot& latest = runs_.shown();
    ShownNumbers numbers;
    for (const RunPanel* const panel : live_.panels()) {
        const ShownNumbers own = panel->numbers(latest);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    QApplication::clipboard()->setText(tabSeparated(numbers));
    host_.tell(tr("%1 readings are on the clipboard").arg(numbers.size()));
}

}  // namespace asperity
