#include "app/session/ForceMapControl.h"

#include "app/maps/MapFiles.h"
#include "app/session/ToolBinding.h"
#include "core/DurationText.h"
#include "core/Error.h"
#include "core/map/PixelCurve.h"
#include "core/scene/SceneChange.h"
#include "ui/CoreWords.h"
#include "ui/NumberText.h"
#include "ui/measure/ForceMapForm.h"
#include "ui/measure/ForceMapPage.h"
#include "ui/measure/PixelCurveView.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

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

}  // namespace

ForceMapControl::ForceMapControl(MainWindow& window, RunControl& runs)
    : window_(window)
    , runs_(runs)
    , page_(new ForceMapPage(&window))
    , line_(loadingLine(window))
    , saving_(window)
    , trial_(
          {.progressed = [](double) {},
           .finished = [this](double& pixelTime) { showEstimate(pixelTime); },
           .failed =
               [this](const std::exception_ptr& reason) { page_->setEstimate(reasonOf(reason)); }})
    , work_({.progressed = [this](double share) { showProgress(share); },
             .finished = [this](std::shared_ptr<HeldMap>&) { take(true); },
             .failed =
                 [this](const std::exception_ptr& reason) {
                     window_.complain(tr("The force map ends: %1").arg(reasonOf(reason)));
                     take(false);
                 },
             .canceled = [this] { take(false); }}) {
    window.addTool(page_, tr("Force map"));
    OverviewMap& map = window.overview().map();
    bindTool(map, pixels_, *page_, &ForceMapPage::pickingChosen, &ForceMapPage::setPicking);
    bindTool(map, rectangle_, page_->form(), &ForceMapForm::drawingChosen,
             &ForceMapForm::setDrawing);
    soon_.setSingleShot(true);
    soon_.setInterval(kEstimateDelay);
    connectParts();
    follow();
}

void ForceMapControl::connectParts() {
    ForceMapForm& form = page_->form();
    connect(&form, &ForceMapForm::changed, this, &ForceMapControl::follow);
    connect(&rectangle_, &RectangleTool::drawn, this,
            [this] { page_->form().setRectangle(rectangle_.rectangle()); });
    connect(&window_.view(), &ZoomView::frameChanged, this, [this] {
        if (const auto frame = window_.view().window()) {
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
        showLayer();
        Q_EMIT layerWanted();
    });
    connect(&pixels_, &PixelTool::pixelChosen, this, &ForceMapControl::showPixel);
}

std::optional<MapPlan> ForceMapControl::plan(QString& refusal) const {
    if (runs_.run() == nullptr) {
        refusal = tr("Open a scan or a scene first");
        return std::nullopt;
    }
    if (!runs_.fixedBy().isEmpty()) {
        refusal = runs_.fixedBy();
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
            tr("; canceled: %1 of %2 rows, the others hold no data").arg(rows).arg(plan.grid.rows);
    }
    const std::vector<MapQuantity> amounts = amountsOf(plan);
    if (std::ranges::find(amounts, shown_) == amounts.end()) {
        shown_ = firstOf(plan.mode);
    }
    pixels_.setPart(std::nullopt);  // its pixel was of the map before
    page_->setQuantities(amounts, shown_);
    page_->pixel().clear(tr("Click a pixel on the whole scan"));
    showLayer();
    Q_EMIT layerWanted();
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
    Q_EMIT layerChanged();
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
    const Vector2 place = plan.place(pixel.y(), pixel.x());
    const MapInstrument instrument(map_->loaded().scene, plan.truth);
    QString title = tr("Pixel %1, %2: x %3, y %4 nm")
                        .arg(pixel.x() + 1)
                        .arg(pixel.y() + 1)
                        .arg(1e9 * place.x(), 0, 'f', 2)
                        .arg(1e9 * place.y(), 0, 'f', 2);
    if (plan.mode == MapMode::Contact) {
        title += tr(". Mode contact has no curve: an approach there");
    }
    if (!map_->part().has(pixel.y())) {
        title += tr(". The map ended before this row");
    }
    page_->pixel().setPixel(title, pixelCurve(instrument, place, plan.setpoint), plan.mode,
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
        window_.tell(tr("Another scan is shown: the force map is canceled"));
    }
    map_.reset();
    pixels_.setPart(std::nullopt);
    page_->setPicking(false);
    page_->setQuantities({}, shown_);
    page_->setState({});
    page_->pixel().clear({});
    if (std::exchange(layer_, std::nullopt)) {
        Q_EMIT layerChanged();
    }
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

}  // namespace asperity
