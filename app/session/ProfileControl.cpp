#include "app/session/ProfileControl.h"

#include "app/session/ToolBinding.h"
#include "ui/measure/ProfilePage.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/MainWindow.h"

#include <algorithm>
#include <limits>

namespace asperity {

namespace {

constexpr int kMinSamples = 65;  ///< of a short line: the surface is smooth between its pixels

Vector2 vectorOf(const QPointF& place) { return {place.x(), place.y()}; }

/// Mean height of places beside one another [m]; NaN: none of them holds data.
double meanHeight(const BSplineSurface& surface, const Vector2& middle, const Vector2& step,
                  int width) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < width; ++i) {
        const Vector2 place = middle + (i - 0.5 * (width - 1)) * step;
        if (surface.contains(place.x(), place.y()) && surface.isMeasured(place.x(), place.y())) {
            sum += surface.at(place.x(), place.y()).height;
            ++count;
        }
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Profile meanProfile(const BSplineSurface& surface, const QLineF& line, int width) {
    const Vector2 from = vectorOf(line.p1());
    const Vector2 to = vectorOf(line.p2());
    const double pitchX = surface.grid().pitchX;
    const double pitchY = surface.grid().pitchY;
    const int samples = std::max(kMinSamples, usualSamples(pitchX, pitchY, from, to));
    if (width <= 1) {
        return profileOf(surface, from, to, samples);
    }
    const Vector2 along = (to - from).normalized();
    const Vector2 step = std::min(pitchX, pitchY) * Vector2(-along.y(), along.x());
    return profileOf(
        [&](double x, double y) {
            return meanHeight(surface, {x, y}, step, width);
        },
        from, to, samples);
}

ProfileControl::ProfileControl(MainWindow& window, RunControl& runs)
    : runs_(runs), page_(new ProfilePage(&window)) {
    window.addTool(page_, tr("Profile"));
    bindTool(window.overview().map(), line_, *page_, &ProfilePage::drawingChosen,
             &ProfilePage::setDrawing);
    connect(&line_, &LineTool::drawn, this, &ProfileControl::refresh);
    connect(page_, &ProfilePage::widthChosen, this, &ProfileControl::refresh);
    connect(page_, &ProfilePage::removeChosen, this, &ProfileControl::forget);
    connect(page_, &ProfilePage::stopsChanged, &line_, [this] { line_.setStops(page_->stops()); });
}

void ProfileControl::forget() {
    line_.clear();
    refresh();
}

/// Some milliseconds at most: a line has a few thousand samples.
void ProfileControl::refresh() {
    if (line_.isEmpty() || runs_.run() == nullptr) {
        page_->setProfile(std::nullopt);
        return;
    }
    const Scene& scene = runs_.run()->scene();
    const Uncertainty& given = scene.description.uncertainty;
    page_->setProfile(meanProfile(scene.surface, line_.line(), page_->width()),
                      given.enabled ? given.heightCalibration : 0.0);
}

}  // namespace asperity
