#include "ui/panels/CyclePanel.h"

#include "ui/Theme.h"
#include "ui/panels/CycleTable.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kMaxOlder = ForceDistancePlot::kMaxCycles - 1;
/// Of the width of a contact: how much of the way to it and back is shown.
constexpr double kFreeShare = 0.4;

}  // namespace

CyclePanel::CyclePanel(QWidget* parent)
    : QWidget(parent)
    , axis_(new QComboBox(this))
    , plot_(new ForceDistancePlot(this))
    , table_(new CycleTable(this)) {
    plot_->setToolTip(tr("Estimated normal force over distance in the last cycles, positive: "
                         "repulsive; a ring marks the pull-off"));
    older_.reserve(kMaxOlder + 1);
    buildHeading();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(plot_, 1);
    column->addWidget(table_);
    refresh();
}

void CyclePanel::buildHeading() {
    axis_->setObjectName(QStringLiteral("distanceAxis"));
    axis_->addItem(tr("separation"));
    axis_->addItem(tr("base position"));
    axis_->setToolTip(tr("Distance axis: separation of tip and undeformed surface, negative: "
                         "indented; or of the undeflected tip, which the base sets"));
    auto* clearAll = new QToolButton(this);
    clearAll->setObjectName(QStringLiteral("clearCycles"));
    clearAll->setText(tr("Clear"));
    clearAll->setToolTip(tr("Forget these curves"));
    for (QWidget* const control : {static_cast<QWidget*>(axis_), static_cast<QWidget*>(clearAll)}) {
        control->setFont(theme::textFont(theme::kSmallSize));
        control->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
        plot_->heading().addWidget(control);
    }
    connect(axis_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        plot_->forgetRange();
        refresh();
    });
    connect(clearAll, &QToolButton::clicked, this, &CyclePanel::clear);
}

void CyclePanel::begin(const QString& material) { present_.material = material; }

void CyclePanel::end() {
    keep();
    detector_ = {};
    number_ = 0;
    refresh();
}

void CyclePanel::take(const TickSample& sample) noexcept {
    detector_.take(sample.time, sample.input, sample.output);
    if (detector_.number() != number_) {
        keep();
        number_ = detector_.number();
    }
    present_.cycle = detector_.cycle();
    present_.trace.take(detector_);
}

/// What is present becomes the newest of the older ones, if the tip touched.
void CyclePanel::keep() {
    if (present_.cycle.touched()) {
        older_.insert(older_.begin(), present_);
        if (older_.size() > kMaxOlder) {
            dropOne();
        }
    }
    present_.cycle = {};
    present_.trace.clear();
}

/// The oldest of which there is a newer one on the same material: each material stays for
/// comparison as long as there is room.
void CyclePanel::dropOne() {
    const auto isRepeated = [this](const Kept& kept) {
        return std::any_of(older_.begin(), older_.end(), [&kept](const Kept& other) {
            return &other < &kept && other.material == kept.material;
        });
    };
    const auto repeated = std::find_if(older_.rbegin(), older_.rend(), isRepeated);
    older_.erase(repeated == older_.rend() ? older_.end() - 1 : std::prev(repeated.base()));
}

void CyclePanel::clear() {
    if (present_.cycle.phase != CyclePhase::Contact) {
        end();
    }
    older_.clear();
    plot_->forgetRange();
    refresh();
}

/// The newest first.
std::vector<const CyclePanel::Kept*> CyclePanel::shown() const {
    std::vector<const Kept*> cycles;
    if (present_.trace.size() > 0) {
        cycles.push_back(&present_);
    }
    for (const Kept& kept : older_) {
        cycles.push_back(&kept);
    }
    return cycles;
}

bool CyclePanel::showsBase() const { return axis_->currentIndex() == 1; }

DrawnCycle CyclePanel::drawn(const Kept& kept) const {
    DrawnCycle cycle;
    const QPointF part(0.0, std::numeric_limits<double>::quiet_NaN());
    CurveBranch before = CurveBranch::Approach;
    for (std::size_t i = 0; i < kept.trace.size(); ++i) {
        const TracePoint& point = kept.trace[i];
        const QPointF place(showsBase() ? point.baseDistance : point.separation, point.force);
        QVector<QPointF>& line =
            point.branch == CurveBranch::Approach ? cycle.approach : cycle.retract;
        if (point.branch != before) {
            QVector<QPointF>& ended =
                before == CurveBranch::Approach ? cycle.approach : cycle.retract;
            ended << place << part;  // the branches meet
        }
        line << place;
        before = point.branch;
    }
    if (kept.cycle.pullOff) {
        cycle.pullOff =
            QPointF(showsBase() ? kept.cycle.pullOffBaseDistance : kept.cycle.pullOffSeparation,
                    -kept.cycle.pullOff->value);
    }
    return cycle;
}

/// The contacts with some of the free way beside them; all of it where there is no contact.
AxisRange CyclePanel::distancesOf(const std::vector<const Kept*>& cycles) const {
    const bool anyTouched = std::any_of(cycles.begin(), cycles.end(),
                                        [](const Kept* kept) { return kept->cycle.touched(); });
    AxisRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const Kept* const kept : cycles) {
        for (std::size_t i = 0; i < kept->trace.size(); ++i) {
            const TracePoint& point = kept->trace[i];
            if (point.contact || !anyTouched) {
                const double distance = showsBase() ? point.baseDistance : point.separation;
                range = {std::min(range.low, distance), std::max(range.high, distance)};
            }
        }
    }
    if (!(range.low <= range.high)) {
        return {};
    }
    const double free = anyTouched ? kFreeShare * (range.high - range.low) : 0.0;
    return {range.low, range.high + free};
}

void CyclePanel::refresh() {
    const std::vector<const Kept*> cycles = shown();
    std::vector<DrawnCycle> curves;
    std::vector<CycleRow> rows;
    for (const Kept* const kept : cycles) {
        curves.push_back(drawn(*kept));
        rows.push_back({kept->material, kept->cycle});
    }
    plot_->setCycles(curves, distancesOf(cycles));
    table_->setRows(rows);
}

}  // namespace asperity
