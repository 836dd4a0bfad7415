#include "app/window/map/ForceMapControl.h"

#include "app/loading/SceneLoader.h"
#include "app/maps/ComparisonReport.h"
#include "app/maps/MapFiles.h"
#include "app/maps/MapJob.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/map/ForceMapPage.h"
#include "app/window/map/PixelCurveView.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/ShareOut.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "core/map/MapPlan.h"
#include "core/map/PixelCycle.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneDescription.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QFile>
#include <QLocale>

#include <algorithm>
#include <chrono>
#include <utility>

namespace asperity {

namespace {

/// @throw Error where a file is an input of the scene, or cannot be written
void requireTargets(const HeldMap& map, const MapFiles& files) {
    for (const std::filesystem::path& target : filesOf(files, map.plan(), true)) {
        forEachFile(map.loaded().scene.description, [&target](const std::string& input) {
            std::error_code none;
            if (std::filesystem::equivalent(input, target, none)) {
                throw Error(target.string() + ": the scene is made of this; give another name");
            }
        });
        requireWritable(target);
    }
}

/// Beside the scan, named after it.
QString suggestionFor(const HeldMap& map) {
    const std::filesystem::path scan = map.loaded().scene.description.sample.file;
    const std::string stem = scan.empty() ? std::string("force") : scan.stem().string();
    return QFile::decodeName((stem + "_map.gwy").c_str());
}

constexpr int kEstimateDelay = 250;  // that what is asked for rests before it is measured [ms]

QString durationOf(double seconds) {
    return seconds < 1.0
               ? ForceMapControl::tr("less than a second")
               : ForceMapControl::tr("about %1").arg(QString::fromStdString(durationText(seconds)));
}

/// "64 × 64 pixels, approach to 5 nN, model"
QString wordsFor(const MapPlan& plan) {
    const QString mode = plan.mode == MapMode::Approach ? ForceMapControl::tr("approach to %1")
                                                        : ForceMapControl::tr("contact at %1");
    return ForceMapControl::tr("%1 × %2 pixels, %3, %4")
        .arg(plan.grid.columns)
        .arg(plan.grid.rows)
        .arg(mode.arg(siText(plan.setpoint, "N")),
             plan.truth ? ForceMapControl::tr("true instrument") : ForceMapControl::tr("model"));
}

QRectF rectangleOf(const MapRegion& region) {
    return {QPointF(region.left, region.bottom), QPointF(region.right, region.top)};
}

/// A sentence of core, for people.
QString sentence(const std::exception& error) {
    QString text = QString::fromUtf8(error.what());
    text[0] = text[0].toUpper();
    return text;
}

/// The quantities that are amounts: flags are none.
std::vector<MapQuantity> amountsOf(const MapPlan& plan) {
    std::vector<MapQuantity> amounts;
    std::ranges::copy_if(plan.quantities, std::back_inserter(amounts),
                         [](MapQuantity quantity) { return quantity != MapQuantity::Validity; });
    return amounts;
}

/// What a new map shows first.
MapQuantity firstOf(MapMode mode) {
    return mode == MapMode::Approach ? MapQuantity::AdhesionForce : MapQuantity::FrictionForce;
}

/// With all terms of the model, as `asperity map` has it: no map must keep up with a tick.
LoadedScene mappedScene(MapSubject& subject) {
    LoadedScene scene =
        withDescription(*subject.present, subject.description, nullptr, ModelFit::Later);
    subject.present.reset();  // the run may adopt another model in between
    return scene;
}

/// Some pixels of the middle row, with the pitch of the map.
MapPlan sampleOf(const MapPlan& plan) {
    constexpr int kPixels = 32;
    MapPlan sample = plan;
    const int row = plan.grid.rows / 2;
    const int columns = std::min(plan.grid.columns, kPixels);
    const int first = (plan.grid.columns - columns) / 2;
    sample.grid = {.columns = columns, .rows = 1};
    sample.region.left = plan.region.left + (first * plan.pitchX());
    sample.region.right = sample.region.left + (columns * plan.pitchX());
    sample.region.bottom = plan.region.bottom + ((plan.grid.rows - row - 1) * plan.pitchY());
    sample.region.top = sample.region.bottom + plan.pitchY();
    return sample;
}

}  // namespace

ForceMapSaving::ForceMapSaving(Host& host)
    : host_(host)
    , work_(loadingLine(host_), {.finished = [this](QString& told) { host_.tell(told); },
                                 .failed = complaintIn(host_)}) {}

void ForceMapSaving::ask(const std::shared_ptr<const HeldMap>& map) {
    const QString file = askWhereToSave(
        &host_.widget(), {.kind = FileKind::Map,
                          .title = QObject::tr("Save the force map"),
                          .suggestion = suggestionFor(*map),
                          .filters = QObject::tr(
                              "Force maps: .gwy, with .vti, .exr and pictures beside it (*.gwy)")});
    if (!file.isEmpty()) {
        saveTo(map, pathOf(file));
    }
}

void ForceMapSaving::saveTo(const std::shared_ptr<const HeldMap>& map,
                            const std::filesystem::path& gwy) {
    const std::filesystem::path path =
        gwy.has_extension() ? gwy : std::filesystem::path(gwy.string() + ".gwy");
    if (lowerCase(path.extension().string()) != ".gwy") {
        host_.complain(QObject::tr("%1: expected the name of a .gwy file").arg(shownPath(path)));
        return;
    }
    const MapFiles files(path);
    for (const std::filesystem::path& file : filesOf(files, map->plan(), true)) {
        std::error_code none;
        if (file != path && std::filesystem::exists(file, none)) {  // the dialog asked for that one
            askWhether(&host_.widget(),
                       QObject::tr("%1 is there already, beside the map. Replace it and the other "
                                   "files of the map?")
                           .arg(shownPath(file)),
                       QObject::tr("Replace"), [this, map, path] { write(map, path); });
            return;
        }
    }
    write(map, path);
}

void ForceMapSaving::write(const std::shared_ptr<const HeldMap>& map,
                           const std::filesystem::path& gwy) {
    const MapFiles files(gwy);
    try {
        requireTargets(*map, files);
        writeMapSheets(files, map->plan(), map->part());  // what draws needs the window's thread
    } catch (const Error& error) {
        host_.complain(QString::fromStdString(printable(error.what())));
        return;
    }
    work_.start(
        QObject::tr("Writing %1 …").arg(shownPath(gwy.filename())),
        [map, files, told = QObject::tr("Saved as %1").arg(shownPath(gwy))](Progress& progress) {
            writeMapFiles(files, map->loaded(), map->plan(), map->part(), &progress);
            return told;
        });
}

ForceMapControl::ForceMapControl(Stage& stage)
    : Feature(stage)
    , page_(new ForceMapPage(&host_.widget()))
    , line_(loadingLine(host_))
    , saving_(host_)
    , trial_(
          {.progressed = [](double) {},
           .finished = [this](double& pixelTime) { showEstimate(pixelTime); },
           .failed =
               [this](const std::exception_ptr& reason) { page_->setEstimate(reasonOf(reason)); }})
    , work_({.progressed = [this](double share) { showProgress(share); },
             .finished = [this](std::shared_ptr<HeldMap>&) { take(true); },
             .failed =
                 [this](const std::exception_ptr& reason) {
                     host_.complain(tr("The force map ends: %1").arg(reasonOf(reason)));
                     take(false);
                 },
             .canceled = [this] { take(false); }}) {
    stage.onFrame(FrameStep::Show, [this](double /*elapsed*/) { show(); });
    host_.addTool(page_, tr("Force map"));
    OverviewMap& map = live_.overview().map();
    bindTool(map, pixels_, *page_, &ForceMapPage::pickingChosen, &ForceMapPage::setPicking);
    bindTool(map, rectangle_, page_->form(), &ForceMapForm::drawingChosen,
             &ForceMapForm::setDrawing);
    soon_.setSingleShot(true);
    soon_.setInterval(kEstimateDelay);
    addEntry();
    connectParts();
    host_.askBeforeClosing(
        [this] { return making_ ? tr("A force map is being computed: it is lost.") : QString(); });
    follow();
}

void ForceMapControl::addEntry() {
    const QAction& entry = host_.menus().add(
        {MenuName::Measure, 0, 60}, "forceMap",
        {.text = tr("&Force map"),
         .tip = tr("Adhesion, stiffness, deformation and friction over the scan or a part of it; a "
                   "force curve at each pixel"),
         .shortcuts = {tr("Ctrl+F")},
         .refusal = [this] { return runs_.changeRefusal(); }});
    connect(&entry, &QAction::triggered, this, [this] { showScanTool(host_, page_); });
    connect(&runs_, &RunControl::begun, this,
            [this] { runs_.isOnOtherScan() ? forget() : refresh(); });
    connect(&runs_, &RunControl::recordingShown, this, [this] { isHidden() ? hide() : refresh(); });
    connect(&runs_, &RunControl::liveShown, this, &ForceMapControl::refresh);
}

void ForceMapControl::connectParts() {
    ForceMapForm& form = page_->form();
    connect(&form, &ForceMapForm::changed, this, &ForceMapControl::follow);
    connect(&rectangle_, &RectangleTool::drawn, this,
            [this] { page_->form().setRectangle(rectangle_.rectangle()); });
    connect(&live_.view(), &ZoomView::frameChanged, this, [this] {
        if (const auto frame = live_.view().window()) {
            page_->form().setView(
                QRectF(QPointF(frame->left, frame->bottom), QPointF(frame->right, frame->top)));
        }
    });
    connect(&soon_, &QTimer::timeout, this, &ForceMapControl::estimate);
    connect(page_, &ForceMapPage::shown, this, [this] {
        if (due_) {
            follow();
        }
    });
    connect(page_, &ForceMapPage::startChosen, this, &ForceMapControl::start);
    connect(page_, &ForceMapPage::cancelChosen, this, &ForceMapControl::cancel);
    connect(page_, &ForceMapPage::saveChosen, this, [this] { saving_.ask(map_); });
    connect(page_, &ForceMapPage::quantityChosen, this, [this](MapQuantity quantity) {
        shown_ = quantity;
        if (!isHidden()) {
            showLayer();
            Q_EMIT stage_.fieldWanted();
        }
    });
    connect(&pixels_, &PixelTool::pixelChosen, this, &ForceMapControl::showPixel);
}

std::optional<MapPlan> ForceMapControl::plan(QString& refusal) const {
    if (runs_.run() == nullptr) {
        refusal = tr("Open a scan or a scene first");
        return std::nullopt;
    }
    if (!runs_.editRefusal().isEmpty()) {
        refusal = runs_.editRefusal();
        return std::nullopt;
    }
    try {
        const MapPlan plan = planMap(runs_.run()->scene(), page_->form().request());
        if (!mapFits(plan)) {
            refusal = tr("A .gwy file holds at most 4 GiB: choose fewer pixels");
            return std::nullopt;
        }
        return plan;
    } catch (const Error& error) {
        refusal = sentence(error);
        return std::nullopt;
    }
}

/// What is asked for is another map.
void ForceMapControl::follow() {
    if (rectangle_.rectangle() != page_->form().rectangle()) {
        rectangle_.setRectangle(page_->form().rectangle());
    }
    QString refusal;
    (void)plan(refusal);
    page_->setRefusal(refusal);
    page_->setEstimate({});
    trial_.cancel();
    due_ = true;
    if (page_->isVisible() && refusal.isEmpty() && !making_) {
        soon_.start();
    }
}

void ForceMapControl::estimate() {
    QString refusal;
    const std::optional<MapPlan> plan = this->plan(refusal);
    if (!plan || making_) {
        return;
    }
    due_ = false;
    page_->setEstimate(tr("Measuring how long it takes …"));
    trial_.start([subject = MapSubject{runs_.run()->shared(), runs_.run()->scene().description,
                                       *plan}](Progress& progress) mutable {
        return measuredPixelTime(std::move(subject), progress);
    });
}

void ForceMapControl::showEstimate(double pixelTime) {
    QString refusal;
    if (const std::optional<MapPlan> plan = this->plan(refusal)) {
        const double pixels = static_cast<double>(plan->grid.columns) * plan->grid.rows;
        page_->setEstimate(
            tr("%1 pixels: %2")
                .arg(QLocale::c().toString(pixels, 'f', 0),
                     durationOf(pixels * pixelTime / std::min(mapThreads(), plan->grid.rows))));
    }
}

void ForceMapControl::start() {
    QString refusal;
    const std::optional<MapPlan> plan = this->plan(refusal);
    if (!plan || making_) {
        return;
    }
    soon_.stop();
    trial_.cancel();
    making_ = std::make_shared<Making>(Making{runs_.run()->scene().description, nullptr});
    begin_ = std::chrono::steady_clock::now();
    page_->setPicking(false);  // so that Esc ends the map, and no tool
    page_->form().setDrawing(false);
    page_->setRunning(true);
    line_.enter([this] { cancel(); });
    showProgress(0.0);
    work_.start([subject = MapSubject{runs_.run()->shared(), making_->scene, *plan},
                 making = making_](Progress& progress) mutable {
        computeHeldMap(std::move(subject), making->map, progress);
        return making->map;
    });
}

/// The rows that are finished stay.
void ForceMapControl::cancel() { work_.cancel(); }

void ForceMapControl::showProgress(double share) {
    if (!making_) {
        return;
    }
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin_;
    QString words = tr("Mapping %1 %").arg(static_cast<int>(100.0 * share));
    if (share > 0.0 && share < 1.0) {
        words += tr(", %1 left").arg(durationOf((1.0 - share) / share * since.count()));
    }
    line_.begin(words);
    line_.setFraction(share);
    page_->setState(isEarlier(making_->scene)
                        ? tr("%1, of the scene as it was at the start").arg(words)
                        : words);
}

void ForceMapControl::leaveWork() {
    line_.leave();
    page_->setRunning(false);
}

/// The work has ended.
void ForceMapControl::take(bool isWhole) {
    const std::shared_ptr<Making> made = std::exchange(making_, nullptr);
    if (!made) {  // another scan is shown
        return;
    }
    leaveWork();
    const int rows = made->map ? made->map->part().count() : 0;
    if (rows == 0) {
        page_->setState(tr("No row was finished"));
        follow();
        return;
    }
    map_ = made->map;
    const MapPlan& plan = map_->plan();
    done_ = wordsFor(plan);
    if (!isWhole) {
        done_ +=
            tr("; canceled: %1 of %2 rows, the others have no data").arg(rows).arg(plan.grid.rows);
    }
    const std::vector<MapQuantity> amounts = amountsOf(plan);
    if (std::ranges::find(amounts, shown_) == amounts.end()) {
        shown_ = firstOf(plan.mode);
    }
    pixels_.setPart(std::nullopt);  // its pixel was of the map before
    page_->setQuantities(amounts, shown_);
    page_->pixel().clear(tr("Click a pixel on the whole scan"));
    if (isHidden()) {
        hide();
        return;
    }
    showLayer();
    Q_EMIT stage_.fieldWanted();
    if (page_->isVisible()) {
        page_->setPicking(true);
    }
    follow();
}

/// The colors, and what is said of them.
void ForceMapControl::showLayer() {
    const bool earlier = isEarlier(map_->loaded().scene.description);
    const QString name = coreWords(rowOf(shown_)->name);
    const QString title = earlier ? tr("%1, earlier scene").arg(name) : name;
    const MapPlan& plan = map_->plan();
    pixels_.setPart(
        MappedPart{rectangleOf(plan.region), {plan.grid.columns, plan.grid.rows}, title});
    layer_ =
        SurfaceField(SurfaceQuantity::ForceMap,
                     std::make_shared<const RegionField>(map_->field(shown_)), title.toStdString());
    showState();
    Q_EMIT stage_.fieldOffered(layer());
}

void ForceMapControl::showState() {
    page_->setState(isEarlier(map_->loaded().scene.description)
                        ? tr("%1. The scene has been changed since: of the scene before").arg(done_)
                        : done_);
}

bool ForceMapControl::isEarlier(const SceneDescription& scene) const {
    return runs_.run() != nullptr &&
           changeBetween(scene, runs_.run()->scene().description) >= SceneChange::Model;
}

void ForceMapControl::showPixel(const QPoint& pixel) {
    const MapPlan& plan = map_->plan();
    const Vector2 position = plan.position(pixel.y(), pixel.x());
    const MapInstrument instrument(map_->loaded().scene, plan.truth);
    QString title = tr("Pixel %1, %2: x %3, y %4 nm")
                        .arg(pixel.x() + 1)
                        .arg(pixel.y() + 1)
                        .arg(1e9 * position.x(), 0, 'f', 2)
                        .arg(1e9 * position.y(), 0, 'f', 2);
    if (plan.mode == MapMode::Contact) {
        title += tr(". Mode contact has no curve: an approach there");
    }
    if (!map_->part().has(pixel.y())) {
        title += tr(". The map ended before this row");
    }
    page_->pixel().setPixel(title, pixelCurve(instrument, position, plan.setpoint), plan.mode,
                            map_->valuesAt(pixel.y(), pixel.x()));
}

void ForceMapControl::saveTo(const std::filesystem::path& gwy) {
    if (map_) {
        saving_.saveTo(map_, gwy);
    }
}

void ForceMapControl::forgetMap() {
    if (std::exchange(making_, nullptr)) {
        work_.cancel();
        leaveWork();
        host_.tell(tr("Another scan is shown: the force map is canceled"));
    }
    map_.reset();
    pixels_.setPart(std::nullopt);
    page_->setPicking(false);
    page_->setQuantities({}, shown_);
    page_->setState({});
    page_->pixel().clear({});
    if (std::exchange(layer_, std::nullopt)) {
        Q_EMIT stage_.fieldOffered(layer());
    }
}

bool ForceMapControl::isHidden() const { return runs_.showsRecording() && runs_.isOnOtherScan(); }

void ForceMapControl::hide() {
    pixels_.setPart(std::nullopt);
    page_->setPicking(false);
    page_->setState(map_ ? tr("The map is of the live scan: it comes back with the live tip")
                         : QString());
    if (std::exchange(layer_, std::nullopt)) {
        Q_EMIT stage_.fieldOffered(layer());
    }
    follow();
}

void ForceMapControl::forget() {
    forgetMap();
    const BSplineSurface& surface = runs_.run()->scene().surface;
    page_->form().setScan({surface.sizeX(), surface.sizeY()});
    refresh();
}

void ForceMapControl::refresh() {
    if (map_ && !making_) {
        showLayer();
    }
    follow();
}

void ForceMapControl::show() {
    const bool isFree = runs_.fixedBy().isEmpty();
    if (page_->isEnabled() != isFree) {
        page_->setEnabled(isFree);
        if (!isFree) {
            cancel();
            page_->setPicking(false);
        }
        follow();
    }
    page_->form().setSetpoint(runs_.run()->scene().description.setpoint);
}

int mapThreads() { return std::max(1, allowedCores() - 1); }

void computeHeldMap(MapSubject subject, std::shared_ptr<HeldMap>& map, Progress& progress) {
    LoadedScene scene = mappedScene(subject);
    map = std::make_shared<HeldMap>(std::move(scene), subject.plan);
    computeMap(map->loaded().scene, map->plan(), map->part(), mapThreads(), &progress);
}

double measuredPixelTime(MapSubject subject, const Progress& progress) {
    const LoadedScene scene = mappedScene(subject);
    const MapPlan sample = sampleOf(subject.plan);
    const MapInstrument instrument(scene.scene, sample.truth);
    std::atomic<bool> ended = false;
    const auto begin = std::chrono::steady_clock::now();
    (void)mapRow(instrument, sample, 0, CancelCheck(&progress, ended, nullptr));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    return took.count() / sample.grid.columns;
}

}  // namespace asperity
