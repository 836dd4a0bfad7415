#include "app/window/export/FilmOfRecording.h"

#include "app/exports/CurveTables.h"
#include "app/exports/PictureFile.h"
#include "app/exports/RunMoment.h"
#include "app/exports/SurfaceFile.h"
#include "app/exports/VideoFile.h"
#include "app/reports/RunPictures.h"
#include "app/window/live/CyclePanel.h"
#include "app/window/live/ForcePanel.h"
#include "app/window/live/LivePanels.h"
#include "core/Error.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/surface/measure/Roughness.h"
#include "core/words/SceneWords.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/OffscreenZoom.h"
#include "ui/view/SecondView.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Theme.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kLook(20);  // for a cancellation

struct Piece {
    std::mutex mutex;  ///< held while it is done: none is given up half-way
    std::condition_variable ended;
    std::function<void()> work;  ///< null: done, or given up
    std::exception_ptr failure;

    void perform() {
        const std::lock_guard lock(mutex);
        if (work) {
            try {
                work();
            } catch (...) {
                failure = std::current_exception();
            }
            work = nullptr;
            ended.notify_one();
        }
    }
};

template <class Value>
ExportOption optionOf(Value value) {
    QString name = QString::fromUtf8(nameOf(value));
    name[0] = name.at(0).toUpper();
    return {.name = name, .key = QString::fromLatin1(keyOf(value))};
}

}  // namespace

void MainThreadExecutor::run(const std::function<void()>& piece, const Progress& progress) {
    const auto shared = std::make_shared<Piece>();
    shared->work = piece;
    later([shared] { shared->perform(); });
    std::unique_lock lock(shared->mutex);
    while (!shared->ended.wait_for(lock, kLook, [&] { return shared->work == nullptr; })) {
        if (progress.isCanceled()) {
            shared->work = nullptr;
            throw Canceled();
        }
    }
    if (shared->failure) {
        std::rethrow_exception(shared->failure);
    }
}

std::vector<ExportOption> filmViews() {
    std::vector<ExportOption> options;
    for (const ExportView view : kValues<ExportView>) {
        if (isSpatial(view)) {
            options.push_back(optionOf(view));
        }
    }
    return options;
}

std::vector<ExportOption> filmMoments() {
    return {optionOf(NamedMoment::Start), optionOf(NamedMoment::SnapIn),
            optionOf(NamedMoment::Deepest), optionOf(NamedMoment::PullOff),
            optionOf(NamedMoment::End)};
}

FilmRequest filmRequest(const FilmChoices& choices, const PictureSpec& spec) {
    const auto view = fromKey<ExportView>(choices.view.toStdString());
    return {.view = view && isSpatial(*view) ? *view : ExportView::Spatial,
            .from = runMoment(choices.from.toStdString()),
            .to = runMoment(choices.to.toStdString()),
            .fps = static_cast<double>(choices.fps),
            .speed = choices.speed,
            .spec = spec};
}

void filmRecording(const std::filesystem::path& recording, const FilmRequest& request,
                   const std::filesystem::path& out, MainThreadExecutor& executor,
                   Progress& progress) {
    ProgressPart loading(&progress, 0.0, 0.1);
    const auto input = std::make_shared<ExportInput>(recording, &loading);
    ProgressPart finding(&progress, 0.1, 0.15);
    const std::vector<std::size_t> ticks = filmTicks(*input->run(), request, &finding);
    ProgressPart drawing(&progress, 0.15, 1.0);
    FilmRenderer artist(
        [input, look = filmLook(request)] { return filmArtist(input->scene(), look); }, executor,
        progress);
    constexpr bool kMayReplace = true;  // what there is was asked for before
    const FilmWork film{*input->run(), artist, ticks};
    isVideo(out) ? writeVideo(film, request, out, &drawing)
                 : writeFrames(film, request, out, kMayReplace, &drawing);
}

FilmRenderer::FilmRenderer(Make make, MainThreadExecutor& executor, const Progress& progress)
    : executor_(executor)
    , progress_(progress)
    , drawing_(std::make_shared<Drawing>(Drawing{std::move(make), nullptr})) {
    executor_.run([this] { drawing_->artist = drawing_->make(); }, progress_);
}

FilmRenderer::~FilmRenderer() {
    executor_.later([drawing = std::move(drawing_)] {});
}

void FilmRenderer::foresee(const TickSample& sample) {
    executor_.run([&] { drawing_->artist->foresee(sample); }, progress_);
}

void FilmRenderer::keepScales() {
    executor_.run([this] { drawing_->artist->keepScales(); }, progress_);
}

RasterImage FilmRenderer::draw(const TickSample& sample, const std::string& caption) {
    RasterImage image;
    executor_.run([&] { image = drawing_->artist->draw(sample, caption); }, progress_);
    return image;
}

namespace {

Color colorOf(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

void addBranch(Chart& chart, const std::string& label, const QVector<QPointF>& points,
               const QColor& color, bool dashed = false) {
    if (points.size() < 2) {  // a tip at rest
        return;
    }
    Curve& curve = chart.curves.emplace_back();
    curve.label = label;
    curve.color = colorOf(color);
    curve.dashed = dashed;
    for (const QPointF& point : points) {
        curve.x.push_back(point.x());
        curve.y.push_back(point.y());
    }
}

/// The newest cycle is drawn last, over the others.
Chart cycleChart(const CyclePanel& panel) {
    const theme::LightColors light;
    Chart chart{.title = "Force–distance curve",
                .xLabel = panel.showsBase() ? "base–sample distance" : "tip–sample separation",
                .yLabel = "normal force",
                .curves = {},
                .xUnit = "m",
                .yUnit = "N"};
    const std::string approach = nameOf(CurveBranch::Approach);
    const std::string retract = nameOf(CurveBranch::Retract);
    const std::vector<DrawnCycle>& cycles = panel.plot().cycles();
    for (std::size_t age = cycles.size(); age-- > 0;) {
        const BranchColors colors = branchColors(static_cast<int>(age));
        const std::string which = age == 0 ? "" : ", " + std::to_string(age) + " before";
        addBranch(chart, approach + which, cycles[age].approach, colors.approach);
        addBranch(chart, retract + which, cycles[age].retract, colors.retract);
    }
    const DrawnMeasurement& measured = panel.plot().measured();
    const std::string name = measured.name.toStdString();
    addBranch(chart, name + ", " + approach, measured.approach, theme::colors().ink);
    addBranch(chart, name + ", " + retract, measured.retract, theme::colors().ink, true);
    return chart;
}

std::string nameOf(const SampleDescription& sample) {
    return sample.shape ? sampleName(sample) : std::filesystem::path(sample.file).stem().string();
}

ExportFormat formatOf(const ExportOrder& order) {
    return formatOf("a." + order.format.toStdString(), viewOf(order.subject));
}

void writePlot(const ExportOrder& order, const ExportMoment& moment) {
    const ExportFormat format = formatOf(order);
    const std::vector<Chart> charts = chartsOf(moment, order.subject);
    if (format != ExportFormat::Csv) {
        writePlotPage(order.path, charts, order.spec, format);
    } else if (order.subject == ExportSubject::Forces) {
        writeForcesTable(order.path, moment.ticks);
    } else {
        writeForceCurvesTable(order.path, charts.front().curves, moment.distance);
    }
}

}  // namespace

ExportMoment presentMoment(LivePanels& live, RunControl& runs) {
    auto& panel = live.forces().cycles();
    panel.refresh();
    const std::filesystem::path open = runs.openRecording();
    const TickSample& sample = runs.shown().sample;
    return {.loaded = runs.shared(),
            .name = open.empty() ? nameOf(runs.scene().description.sample) : exportName(open),
            .sample = sample,
            .patch = zoomGrid(runs.scene(), sample),
            .section = live.second().section().sectionOf(runs.scene(), sample.output.model),
            .view = *live.view().shown(),
            .ticks = runs.shownTicks(),
            .cycles = cycleChart(panel),
            .distance = panel.showsBase() ? "base_distance_m" : "separation_m"};
}

OffscreenZoomLook viewLook(const ExportMoment& moment, const PictureSpec& spec) {
    OffscreenZoomLook look = spatialLook(ExportView::Spatial, spec);
    look.shown = moment.view;
    return look;
}

RasterImage viewImage(const ExportMoment& moment, const PictureSpec& spec) {
    return OffscreenZoom(moment.loaded->scene, viewLook(moment, spec)).draw(moment.sample, {});
}

std::vector<Chart> chartsOf(const ExportMoment& moment, ExportSubject subject) {
    if (subject == ExportSubject::Cycle) {
        if (moment.cycles.curves.empty()) {
            throw Error("There is no force–distance curve yet: bring the tip to the sample first.");
        }
        return {moment.cycles};
    }
    if (moment.ticks.empty()) {
        throw Error("There are no forces to plot yet: start the run first.");
    }
    RunCurves curves;
    for (const TickSample& sample : moment.ticks) {
        curves.take(sample);
    }
    std::vector<Chart> charts = curves.charts();
    std::erase_if(charts, [](const Chart& chart) { return chart.xUnit != "s"; });
    return charts;
}

ExportView viewOf(ExportSubject subject) {
    switch (subject) {
    case ExportSubject::Forces:
        return ExportView::Forces;
    case ExportSubject::Cycle:
        return ExportView::Cycle;
    case ExportSubject::Deformation:
        return ExportView::Deformation;
    default:
        return ExportView::Spatial;
    }
}

ExportWork pictureWork(const ExportOrder& order, RasterImage image) {
    return [order, image = std::move(image)](Progress&) {
        writePicture(order.path, image, formatOf(order), order.spec.dpi);
    };
}

ExportWork dataWork(const ExportOrder& order, std::shared_ptr<const ExportMoment> moment) {
    return [order, moment = std::move(moment)](Progress& progress) {
        const Scene& scene = moment->loaded->scene;
        if (order.subject == ExportSubject::Deformation) {
            writeField(order.path, zoomPatch(scene, moment->sample, moment->patch),
                       formatOf(order));
        } else if (order.subject == ExportSubject::Section) {
            if (!moment->section) {
                throw Error("There is no section: the tip has no equilibrium position.");
            }
            writeSectionTable(order.path, *moment->section);
        } else if (order.subject == ExportSubject::Surface) {
            writeHeightMap(order.path, rowsOf(scene.surface), {.title = moment->name}, &progress,
                           surfaceFormats());
        } else {
            writePlot(order, *moment);
        }
    };
}

}  // namespace asperity
