#include "app/FrameShow.h"

#include "ui/MainWindow.h"
#include "ui/panels/CantileverPanel.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ZoomView.h"

namespace asperity {

void FrameShow::take(const TickSample& sample) {
    window_.forces().take(sample);
    window_.cantilever().take(sample);
    window_.banner().take(sample);
}

void FrameShow::show(const Snapshot& latest, double now) {
    window_.view().showSnapshot(latest);
    counters_.at(Zoom).add(now);
    window_.banner().show(latest);
    window_.loopStatus().show(latest.statistics);
    window_.loopStatus().setFramesPerSecond(counters_.at(Zoom).rate());
    showSmallPanel(latest, now);
}

// The small panels take turns: each redraw costs Qt a composition of its part of the window.
void FrameShow::showSmallPanel(const Snapshot& latest, double now) {
    turn_ = turn_ % Overview + 1;
    if (turn_ == Forces) {
        window_.forces().show(latest);
    } else if (turn_ == Cantilever) {
        window_.cantilever().show(latest);
    } else {
        window_.overview().show(latest);
    }
    counters_.at(turn_).add(now);
}

void FrameShow::showEverywhere(const Snapshot& latest) {
    window_.view().showSnapshot(latest);
    window_.banner().show(latest);
    window_.forces().show(latest);
    window_.cantilever().show(latest);
    window_.overview().show(latest);
}

std::vector<ViewRate> FrameShow::rates() const {
    constexpr std::array<const char*, ViewCount> kNames{"zoom", "forces", "cantilever", "overview"};
    std::vector<ViewRate> rates;
    for (std::size_t view = 0; view < ViewCount; ++view) {
        rates.push_back({kNames.at(view), counters_.at(view).overallRate()});
    }
    return rates;
}

}  // namespace asperity
