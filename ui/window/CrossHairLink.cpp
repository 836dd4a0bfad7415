#include "ui/window/CrossHairLink.h"

#include "ui/panels/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/window/SecondView.h"

namespace asperity {

CrossHairLink::CrossHairLink(ZoomView& view, SecondView& second, OverviewMap& map)
    : view_(view), second_(second), map_(map) {
    follow(view);
    follow(second);
    follow(map);
    connect(&view, &ZoomView::readingChanged, this, &CrossHairLink::showInOthers);
}

template <class View>
void CrossHairLink::follow(View& view) {
    connect(&view, &View::placeHovered, this, [this](double x, double y) { point(Vector2(x, y)); });
    connect(&view, &View::placeLeft, this, [this] { point(std::nullopt); });
}

void CrossHairLink::point(const std::optional<Vector2>& place) {
    const std::optional<Vector2> shown = isOn_ ? place : std::nullopt;
    if (shown != place_) {
        place_ = shown;
        view_.showCrossHair(shown);
        showInOthers();
    }
}

void CrossHairLink::setOn(bool on) {
    isOn_ = on;
    point(place_);
}

void CrossHairLink::showInOthers() {
    const std::optional<SurfaceReading> read = place_ ? view_.reading(*place_) : std::nullopt;
    second_.showCrossHair(place_, read);
    map_.showCrossHair(place_ ? std::optional(QPointF(place_->x(), place_->y())) : std::nullopt,
                       read ? textOf(*read) : QString());
}

}  // namespace asperity
