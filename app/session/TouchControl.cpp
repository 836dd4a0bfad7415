#include "app/session/TouchControl.h"

#include "app/reports/TouchTable.h"
#include "core/Error.h"
#include "core/words/SceneWords.h"
#include "ui/measure/TouchesPage.h"
#include "ui/panels/OverviewMap.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/Dialogs.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

namespace {

constexpr std::size_t kTouchRoom = 64;  ///< touches between two frames
constexpr int kFramesPerUpdate = 8;     ///< of a touch that goes on: five times a second

}  // namespace

TouchControl::TouchControl(MainWindow& window, RunControl& runs)
    : window_(window), runs_(runs), page_(new TouchesPage(&window)) {
    fresh_.reserve(kTouchRoom);
    window.addTool(page_, tr("Touches"));
    window.overview().map().addTool(marks_);
    connect(page_, &TouchesPage::markingChosen, &marks_, &TouchMarks::setShown);
    connect(page_, &TouchesPage::selectionChanged, &marks_,
            [this] { marks_.setSelected(page_->selected()); });
    connect(page_, &TouchesPage::exportChosen, this, &TouchControl::askForFile);
    connect(page_, &TouchesPage::clearChosen, this, &TouchControl::clear);
    connect(&runs, &RunControl::ending, this, &TouchControl::end);
    connect(&runs, &RunControl::begun, this, &TouchControl::begin);
}

void TouchControl::begin() {
    const SampleDescription& sample = runs_.run()->scene().description.sample;
    material_ = QString::fromStdString(sample.material.name).replace('_', ' ');
    scan_ = QString::fromStdString(sampleName(sample));
    markAll();
}

void TouchControl::end() {
    update(true);
    detector_ = {};
    number_ = -1;
}

void TouchControl::take(const TickSample& sample) {
    detector_.take(sample.time, sample.input, sample.output);
    if (!detector_.cycle().touched()) {
        return;
    }
    if (detector_.number() != number_) {
        number_ = detector_.number();
        fresh_.push_back({detector_.cycle(), material_, scan_});
    } else if (fresh_.empty()) {
        continues_ = true;
        fresh_.push_back({detector_.cycle(), material_, scan_});
    } else {
        fresh_.back().cycle = detector_.cycle();
    }
}

void TouchControl::show() {
    const bool more = fresh_.size() > (continues_ ? 1U : 0U);
    if (!more && ++framesSince_ < kFramesPerUpdate) {
        return;
    }
    update(more);
}

void TouchControl::update(bool more) {
    framesSince_ = 0;
    TouchModel& model = page_->model();
    for (Touch& touch : fresh_) {
        if (touch.cycle.complete() && runs_.run() != nullptr) {
            touch.budgets = cycleBudgets(runs_.run()->scene(), touch.cycle);
        }
        if (std::exchange(continues_, false)) {
            if (model.rowCount() > 0) {  // it may have been cleared
                model.updateLast(touch);
            }
        } else {
            model.append(touch);
        }
    }
    fresh_.clear();
    if (more) {
        markAll();
    }
}

void TouchControl::clear() {
    page_->model().clear();
    fresh_.clear();
    continues_ = false;
    markAll();
}

/// Those of the scan that is shown.
void TouchControl::markAll() {
    QVector<MarkedTouch> marked;
    const std::vector<Touch>& touches = page_->model().touches();
    for (std::size_t i = 0; i < touches.size(); ++i) {
        if (touches[i].scan == scan_) {
            const Vector2& place = touches[i].cycle.place;
            marked.append({static_cast<int>(i) + 1, {place.x(), place.y()}});
        }
    }
    marks_.setTouches(marked);
}

void TouchControl::askForFile() {
    const QString file = askForTable(&window_);
    if (!file.isEmpty()) {
        writeTo(file.toStdString());
    }
}

void TouchControl::writeTo(const std::filesystem::path& file) {
    update(true);
    try {
        writeTouches(file, page_->model().touches());
        window_.tell(tr("Saved as %1").arg(QString::fromStdString(file.string())));
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
}

}  // namespace asperity
