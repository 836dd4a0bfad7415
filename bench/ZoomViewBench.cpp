// Frames per second of the zoomed view with the haptic loop running, camera still and moving,
// beside four nearly empty QVTK widgets. Display: xvfb-run -a -s "-screen 0 1600x1000x24" PROGRAM.
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticLoop.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/ZoomView.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QGridLayout>
#include <QMouseEvent>
#include <QTimer>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr int kWidth = 1200;
constexpr int kHeight = 800;
constexpr double kWarmUp = 1.0;         // [s]
constexpr double kDuration = 5.0;       // of one measurement [s]
constexpr double kQuickDuration = 2.0;  // [s]

/// Measurements of one way to draw.
struct Timing {
    double framesPerSecond = 0.0;
    std::vector<double> calls;  ///< time that each drawing call took, rising [s]

    [[nodiscard]] double quantile(double part) const {
        return calls.at(static_cast<std::size_t>(part * static_cast<double>(calls.size() - 1)));
    }
};

/// Draws again whenever the view says that a frame is out: `shown` is emitted once a frame.
template <class View, class Shown>
Timing measure(View& view, Shown shown, double duration, const std::function<void()>& draw) {
    QEventLoop loop;
    QElapsedTimer clock;
    Timing timing;
    double begin = 0.0;
    clock.start();
    const auto now = [&clock] { return static_cast<double>(clock.nsecsElapsed()) * 1e-9; };
    const auto next = [&] {
        const double start = now();
        draw();
        const double end = now();
        if (start < kWarmUp) {
            begin = end;
        } else {
            timing.calls.push_back(end - start);
        }
        if (end > kWarmUp + duration) {
            loop.quit();
        }
    };
    QTimer due;
    due.setSingleShot(true);
    QObject::connect(&due, &QTimer::timeout, &loop, next);
    QObject::connect(&view, shown, &due, [&due] { due.start(0); });
    due.start(0);
    loop.exec();
    timing.framesPerSecond = static_cast<double>(timing.calls.size()) / (now() - begin);
    std::sort(timing.calls.begin(), timing.calls.end());
    return timing;
}

void print(const char* what, const Timing& timing) {
    std::printf("%-44s %6.1f frames/s   call p50 %5.1f  p99 %5.1f  max %5.1f ms\n", what,
                timing.framesPerSecond, 1e3 * timing.quantile(0.5), 1e3 * timing.quantile(0.99),
                1e3 * timing.calls.back());
    std::fflush(stdout);
}

/// One widget with next to nothing in it.
struct EmptyView {
    QVTKOpenGLNativeWidget widget;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkSphereSource> ball;

    EmptyView() {
        QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
        format.setSamples(0);
        widget.setFormat(format);
        window->SetMultiSamples(0);
        widget.setRenderWindow(window.Get());
        vtkNew<vtkRenderer> renderer;
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(ball->GetOutputPort());
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        renderer->AddActor(actor);
        window->AddRenderer(renderer);
    }
};

double fourEmptyViews(double duration) {
    QWidget all;
    auto* grid = new QGridLayout(&all);
    std::vector<std::unique_ptr<EmptyView>> views;
    for (int i = 0; i < 4; ++i) {
        views.push_back(std::make_unique<EmptyView>());
        grid->addWidget(&views.back()->widget, i / 2, i % 2);
    }
    all.resize(kWidth, kHeight);
    all.show();
    const Timing timing =
        measure(views.front()->widget, &QOpenGLWidget::frameSwapped, duration, [&] {
            for (const auto& view : views) {
                view->window->Render();
            }
        });
    print("four nearly empty QVTK widgets", timing);
    for (const auto& view : views) {
        view->widget.setParent(nullptr);
    }
    return timing.framesPerSecond;
}

Scene benchScene() {
    const ScanSize size{.columns = 1024, .rows = 1024, .sizeX = 4e-6, .sizeY = 4e-6};
    const SelfAffine roughness{
        .rms = 15e-9, .longestWave = 4e-6, .rollOffWave = 1e-6, .shortestWave = 3e-8};
    return buildScene(defaultScene(), selfAffineMap(size, roughness));
}

/// Turns the view as a user's mouse would.
void turn(ZoomView& view, int& pixel) {
    const auto send = [&view](QEvent::Type type, int x) {
        QMouseEvent event(type, QPointF(x, 300.0), Qt::RightButton, Qt::RightButton,
                          Qt::NoModifier);
        QApplication::sendEvent(&view, &event);
    };
    send(QEvent::MouseButtonPress, pixel);
    send(QEvent::MouseMove, pixel + 3);
    pixel = (pixel + 3) % 600;
}

BenchRow rowOf(double width, const char* camera, const Timing& timing, double goal) {
    std::ostringstream name;
    name << "view " << kWidth << " x " << kHeight << " of " << std::lround(1e9 * width)
         << " nm, loop running: camera " << camera;
    return {.name = name.str(), .value = timing.framesPerSecond, .unit = "frames/s", .goal = goal};
}

void measureView(ZoomView& view, HapticLoop& loop, double empty, double duration,
                 std::vector<BenchRow>& rows) {
    const auto frame = [&] { view.showSnapshot(loop.snapshot()); };
    int pixel = 0;
    const auto turnedFrame = [&] {
        turn(view, pixel);
        frame();
    };
    for (const bool cached : {true, false}) {
        view.setCacheEnabled(cached);
        const Timing still = measure(view, &ZoomView::painted, duration, frame);
        print(cached ? "  camera still, cached" : "  camera still, no cache", still);
        const Timing moving = measure(view, &ZoomView::painted, duration, turnedFrame);
        print(cached ? "  camera moving, cached" : "  camera moving, no cache", moving);
        std::printf("  ratio to four empty widgets: still %.2f, moving %.2f\n",
                    still.framesPerSecond / empty, moving.framesPerSecond / empty);
        if (cached) {
            rows.push_back(rowOf(2.0 * view.halfWidth(), "still", still, 60.0));
            rows.push_back(rowOf(2.0 * view.halfWidth(), "moving", moving, 45.0));
        }
    }
}

/// The same with what a user can switch on, one after the other and then all together.
void measureOptions(ZoomView& view, HapticLoop& loop, const Scene& scene, double duration) {
    ZoomView second;
    ContactPlot section;
    second.setScene(&scene);
    section.setScene(&scene);
    for (QWidget* widget : {static_cast<QWidget*>(&second), static_cast<QWidget*>(&section)}) {
        widget->resize(kWidth / 2, kHeight);
    }
    bool isSecondShown = false;
    bool isEven = false;
    const auto frame = [&] {
        const Snapshot& snapshot = loop.snapshot();
        view.showSnapshot(snapshot);
        isEven = !isEven;
        if (isEven && isSecondShown) {  // as the window does: every second time
            second.showSnapshot(snapshot);
            section.showSnapshot(snapshot);
        }
    };
    const auto colorBy = [&view](SurfaceQuantity quantity) {
        SurfaceLook look;
        look.quantity = quantity;
        view.setLook(look, SurfaceField(quantity));
    };
    const auto measured = [&](const char* what) {
        print(what, measure(view, &ZoomView::painted, duration, frame));
    };
    measured("  heights alone");
    for (const SurfaceQuantity quantity :
         {SurfaceQuantity::Slope, SurfaceQuantity::Gap, SurfaceQuantity::Pressure,
          SurfaceQuantity::Displacement}) {
        colorBy(quantity);
        measured((std::string("  color by ") + nameOf(quantity)).c_str());
    }
    view.showCrossHair(Vector2(0.5 * scene.surface.sizeX(), 0.5 * scene.surface.sizeY()));
    measured("  and a cross-hair");
    view.setOptions({.commandedTip = true, .trueTip = true});
    measured("  and both ghosts");
    section.show();
    isSecondShown = true;
    measured("  and a section beside");
    section.hide();
    second.show();
    measured("  and a second 3-D view in place of it");
    second.setScene(nullptr);
    view.setOptions({});
    view.showCrossHair(std::nullopt);
    colorBy(SurfaceQuantity::Height);
}

void measureAll(const BenchOptions& options) {
    const double duration = options.quick ? kQuickDuration : kDuration;
    const double empty = fourEmptyViews(duration);
    std::vector<BenchRow> rows;

    const Scene scene = benchScene();
    ScriptedDevice device(rasterPath(scene, {.duration = 60.0}), 1.0);
    SimulatedAfm afm(scene.surface, truthOf(scene));
    HapticLoop loop(scene, device, afm);
    loop.start();
    ZoomView view;
    view.resize(kWidth, kHeight);
    view.show();
    view.setScene(&scene);
    for (const double zoom : {1.0, 15.0}) {
        view.resetCamera();
        view.setHalfWidth(zoom * view.halfWidth());
        std::printf("view of %.0f nm, %d x %d pixels, loop at %.0f Hz:\n", 2e9 * view.halfWidth(),
                    kWidth, kHeight, scene.description.tickRate);
        measureView(view, loop, empty, duration, rows);
    }
    view.resetCamera();
    view.setCacheEnabled(true);
    if (!options.quick) {
        std::printf("camera still, cached, with options:\n");
        measureOptions(view, loop, scene, duration);
    }
    loop.stop();
    const LoopStatistics statistics = loop.snapshot().statistics;
    std::printf("loop: %ld ticks, %ld overruns\n", statistics.ticks, statistics.overruns);
    giveRows(rows, options);
}

int runBench(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("Frames per second of the zoomed view while the loop runs");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0);
    format.setSwapInterval(0);
    QSurfaceFormat::setDefaultFormat(format);
    const QApplication application(argc, argv);
    measureAll(options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
