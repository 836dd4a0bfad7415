#include "app/session/RoughnessControl.h"

#include "app/session/ToolBinding.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

QString levelingText(const SampleDescription& sample) {
    return QString::fromStdString(textOf(sample.leveling)).replace('_', ' ');
}

QString smoothingText(const SampleDescription& sample) {
    if (sample.smoothingLength > 0.0) {
        return RoughnessControl::tr("Gaussian, standard deviation %1 nm")
            .arg(1e9 * sample.smoothingLength, 0, 'g', 3);
    }
    const double pixels = sample.smoothingPixels.value_or(0.0);
    return pixels > 0.0
               ? RoughnessControl::tr("Gaussian, standard deviation %1 px").arg(pixels, 0, 'g', 3)
               : RoughnessControl::tr("none");
}

}  // namespace

RoughnessControl::RoughnessControl(MainWindow& window, RunControl& runs)
    : runs_(runs)
    , page_(new RoughnessPage(&window))
    , work_({.progressed = [this](double share) { page_->setProgress(share); },
             .finished =
                 [this](Result& result) { page_->setResult(result.subject, result.roughness); },
             .failed =
                 [this](const std::exception_ptr& reason) { page_->clear(reasonOf(reason)); }}) {
    window.addTool(page_, tr("Roughness"));
    bindTool(window.overview().map(), rectangle_, *page_, &RoughnessPage::drawingChosen,
             &RoughnessPage::setDrawing);
    connect(&rectangle_, &RectangleTool::drawn, this, &RoughnessControl::refresh);
    connect(page_, &RoughnessPage::wholeChosen, this, &RoughnessControl::forget);
    connect(page_, &RoughnessPage::shown, this, [this] {
        if (due_) {
            refresh();
        }
    });
}

void RoughnessControl::forget() {
    rectangle_.clear();
    refresh();
}

RoughnessControl::Result RoughnessControl::compute(const Scene& scene, const QRectF& rectangle,
                                                   Progress& progress) {
    const BSplineSurface& surface = scene.surface;
    const HeightRows rows = rowsOf(surface);
    const PixelRectangle pixels = rectangle.isEmpty()
                                      ? allPixels(rows)
                                      : pixelsBetween(rows, {rectangle.left(), rectangle.top()},
                                                      {rectangle.right(), rectangle.bottom()});
    return {.subject = {.width = pixels.columns * surface.grid().pitchX,
                        .height = pixels.rows * surface.grid().pitchY,
                        .pixels = static_cast<std::size_t>(pixels.columns) *
                                  static_cast<std::size_t>(pixels.rows),
                        .isRectangle = !rectangle.isEmpty(),
                        .leveling = levelingText(scene.description.sample),
                        .smoothing = smoothingText(scene.description.sample)},
            .roughness = roughnessOf(rows, pixels, &progress)};
}

void RoughnessControl::refresh() {
    page_->setRectangle(!rectangle_.isEmpty());
    work_.cancel();
    due_ = !page_->isVisible();
    if (runs_.run() == nullptr) {
        page_->clear({});
    } else if (!due_) {
        page_->setProgress(0.0);
        work_.start([loaded = runs_.run()->shared(),
                     rectangle = rectangle_.rectangle()](Progress& progress) {
            return compute(loaded->scene, rectangle, progress);
        });
    }
}

}  // namespace asperity
