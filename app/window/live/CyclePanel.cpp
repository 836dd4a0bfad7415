#include "app/window/live/CyclePanel.h"

#include "app/window/live/CycleTable.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kMaxOlder = ForceDistancePlot::kMaxCycles - 1;
/// Of the width of a contact: how much of the way to it and back is shown.
constexpr double kFreeShare = 0.4;

constexpr double kMaxOffset = 1e6;     ///< [nm]
constexpr int kMeasuredBoxWidth = 92;  ///< [px]

}  // namespace

CyclePanel::CyclePanel(QWidget* parent)
    : QWidget(parent)
    , axis_(new QComboBox(this))
    , plot_(new ForceDistancePlot(this))
    , table_(new CycleTable(this))
    , bar_(new MeasuredBar(this)) {
    plot_->setToolTip(tr("Estimated normal force over distance in the last cycles, positive: "
                         "repulsive; a ring marks the pull-off") +
                      QLatin1Char('\n') + PlotNavigation::help());
    cycles_.older.reserve(kMaxOlder + 1);
    buildHeading();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(plot_, 1);
    column->addWidget(bar_);
    column->addWidget(table_);
    connect(table_, &CycleTable::rowClicked, this, &CyclePanel::toggle);
    table_->setBudgetSource([this](int row) {
        Kept& kept = keptAt(row);
        takeBudgets(kept);
        return kept.budgets;
    });
    connect(bar_, &MeasuredBar::offsetChanged, this, &CyclePanel::refresh);
    connect(bar_, &MeasuredBar::removeChosen, this, [this] { setMeasured(std::nullopt); });
    refresh();
}

void CyclePanel::buildHeading() {
    axis_->setObjectName(QStringLiteral("distanceAxis"));
    axis_->addItem(tr("separation"));
    axis_->addItem(tr("base position"));
    axis_->setToolTip(tr("Distance axis: separation of tip and undeformed surface, negative: "
                         "indented; or of the undeflected tip, which the base sets"));
    auto* load = new QToolButton(this);
    load->setObjectName(QStringLiteral("loadMeasured"));
    load->setText(tr("…"));
    load->setToolTip(tr("Draw a measured force–distance curve from a text file over these"));
    auto* clearAll = new QToolButton(this);
    clearAll->setObjectName(QStringLiteral("clearCycles"));
    clearAll->setText(tr("Clear"));
    clearAll->setToolTip(tr("Forget these curves"));
    for (QWidget* const control : {static_cast<QWidget*>(axis_), static_cast<QWidget*>(load),
                                   static_cast<QWidget*>(clearAll)}) {
        control->setFont(theme::textFont(theme::kSmallSize));
        control->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
        control->setProperty("compact", true);
        plot_->heading().addWidget(control);
    }
    connect(axis_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        plot_->forgetRange();
        refresh();
    });
    connect(load, &QToolButton::clicked, this, &CyclePanel::measuredCurveWanted);
    connect(clearAll, &QToolButton::clicked, this, &CyclePanel::clear);
}

void CyclePanel::begin(const QString& material, const Scene* scene) {
    cycles_.present.material = material;
    cycles_.present.run = ++runs_;
    scene_ = scene;
}

void CyclePanel::end() {
    endCycle();
    for (Kept& kept : cycles_.older) {
        takeBudgets(kept);  // there is no scene later
    }
    scene_ = nullptr;
    refresh();
}

void CyclePanel::endCycle() {
    keep();
    detector_ = {};
    number_ = 0;
}

void CyclePanel::restart() {
    endCycle();
    cycles_.older.clear();
    plot_->forgetRange();
    refresh();
}

std::function<void()> CyclePanel::keptCycles() {
    return [this, runs = runs_, detector = detector_, number = number_, cycles = cycles_,
            paused = paused_] {
        runs_ = runs;
        detector_ = detector;
        number_ = number;
        cycles_ = cycles;
        paused_ = paused;
        plot_->forgetRange();
        refresh();
    };
}

void CyclePanel::take(const TickSample& sample) noexcept {
    detector_.take(sample.time, sample.input, sample.output);
    if (detector_.number() != number_) {
        keep();
        number_ = detector_.number();
    }
    cycles_.present.cycle = detector_.cycle();
    cycles_.present.trace.take(detector_);
}

/// What is present becomes the newest of the older ones, if the tip touched.
void CyclePanel::keep() {
    if (cycles_.present.cycle.touched()) {
        cycles_.older.insert(cycles_.older.begin(), cycles_.present);
        if (cycles_.older.size() > kMaxOlder) {
            dropOne();
        }
    }
    cycles_.present.budgets.reset();
    cycles_.present.cycle = {};
    cycles_.present.trace.clear();
    cycles_.present.hidden = false;
}

void CyclePanel::takeBudgets(Kept& kept) const {
    const ContactCycle& cycle = kept.cycle;
    const bool isKnown = kept.budgets && cycle.complete();
    if (scene_ != nullptr && kept.run == runs_ && cycle.touched() && !isKnown) {
        kept.budgets = budgetsAt(*scene_, cycle.position, cycle.maxForce.value_or(Reading{}).value);
    }
}

/// The oldest of which there is a newer one on the same material: each material stays for
/// comparison as long as there is room.
void CyclePanel::dropOne() {
    const auto isRepeated = [this](const Kept& kept) {
        return std::any_of(cycles_.older.begin(), cycles_.older.end(), [&kept](const Kept& other) {
            return &other < &kept && other.material == kept.material;
        });
    };
    const auto repeated = std::find_if(cycles_.older.rbegin(), cycles_.older.rend(), isRepeated);
    cycles_.older.erase(repeated == cycles_.older.rend() ? cycles_.older.end() - 1
                                                         : std::prev(repeated.base()));
}

void CyclePanel::clear() {
    if (cycles_.present.cycle.phase != CyclePhase::Contact) {
        endCycle();
    }
    cycles_.older.clear();
    if (paused_) {
        paused_ = cycles_;
    }
    plot_->forgetRange();
    refresh();
}

/// The newest first.
std::vector<const CyclePanel::Kept*> CyclePanel::shown() const {
    std::vector<const Kept*> cycles;
    if (drawnCycles().present.trace.size() > 0) {
        cycles.push_back(&drawnCycles().present);
    }
    for (const Kept& kept : drawnCycles().older) {
        cycles.push_back(&kept);
    }
    return cycles;
}

CyclePanel::Kept& CyclePanel::keptAt(int row) {
    Cycles& cycles = paused_ ? *paused_ : cycles_;
    const int older = cycles.present.trace.size() > 0 ? row - 1 : row;
    return older < 0 ? cycles.present : cycles.older.at(static_cast<std::size_t>(older));
}

void CyclePanel::toggle(int row) {
    Kept& kept = keptAt(row);
    kept.hidden = !kept.hidden;
    refresh();
}

void CyclePanel::setPaused(bool paused) {
    if (paused != paused_.has_value()) {
        paused_ = paused ? std::optional(cycles_) : std::nullopt;
        refresh();
    }
}

void CyclePanel::setMeasured(const std::optional<MeasuredCurve>& curve) {
    measured_ = curve;
    bar_->setCurve(curve ? curve->name : QString(), curve ? curve->details : QString());
    plot_->forgetRange();
    refresh();
}

DrawnMeasurement CyclePanel::drawnMeasurement() const {
    if (!measured_) {
        return {};
    }
    const auto moved = [this](const MeasuredBranchPoints& branch) {
        QVector<QPointF> points = showsBase() ? branch.overBase : branch.overSeparation;
        for (QPointF& point : points) {
            point.rx() += bar_->offset();
        }
        return points;
    };
    return {measured_->name, moved(measured_->approach), moved(measured_->retract)};
}

bool CyclePanel::showsBase() const { return axis_->currentIndex() == 1; }

DrawnCycle CyclePanel::drawn(const Kept& kept) const {
    DrawnCycle cycle;
    const QPointF part(0.0, std::numeric_limits<double>::quiet_NaN());
    CurveBranch before = CurveBranch::Approach;
    for (std::size_t i = 0; i < kept.trace.size(); ++i) {
        const TracePoint& point = kept.trace[i];
        const QPointF position(showsBase() ? point.baseDistance : point.separation, point.force);
        QVector<QPointF>& line =
            point.branch == CurveBranch::Approach ? cycle.approach : cycle.retract;
        if (point.branch != before) {
            QVector<QPointF>& ended =
                before == CurveBranch::Approach ? cycle.approach : cycle.retract;
            ended << position << part;  // the branches meet
        }
        line << position;
        before = point.branch;
    }
    if (const std::optional<Reading> pullOff = kept.cycle.pullOffForce()) {
        cycle.pullOff =
            QPointF(showsBase() ? kept.cycle.pullOffBaseDistance : kept.cycle.pullOffSeparation,
                    -pullOff->value);
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
    if (measured_) {
        range = {std::min(range.low, measured_->contact.low + bar_->offset()),
                 std::max(range.high, measured_->contact.high + bar_->offset())};
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
        curves.push_back(kept->hidden ? DrawnCycle() : drawn(*kept));
        rows.push_back({kept->material, kept->cycle, kept->hidden});
    }
    plot_->setCycles(curves, distancesOf(cycles), drawnMeasurement());
    table_->setRows(rows);
}

MeasuredBar::MeasuredBar(QWidget* parent)
    : QWidget(parent), name_(new QLabel(this)), offset_(new NumberBox(this)) {
    setToolTip(tr("A measured curve that is drawn over the cycles"));
    name_->setObjectName(QStringLiteral("measuredName"));
    name_->setMinimumWidth(1);
    offset_->setObjectName(QStringLiteral("measuredOffset"));
    offset_->setRange(-kMaxOffset, kMaxOffset);
    offset_->setSuffix(tr(" nm"));
    offset_->setSingleStep(0.1);
    offset_->setFixedWidth(kMeasuredBoxWidth);
    offset_->setToolTip(tr("Moves the measured curve along the distance axis [nm]; at 0 its "
                           "contact, where its approach last passes zero force, is at 0"));
    auto* remove = new QToolButton(this);
    remove->setObjectName(QStringLiteral("removeMeasured"));
    remove->setText(tr("Remove"));
    remove->setToolTip(tr("Takes the measured curve out of the plot"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(name_, 1);
    row->addWidget(offset_);
    row->addWidget(remove);
    for (QWidget* const widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(offset_),
                                  static_cast<QWidget*>(remove)}) {
        widget->setFont(theme::textFont(theme::kSmallSize));
    }
    remove->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    connect(offset_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &MeasuredBar::offsetChanged);
    connect(remove, &QToolButton::clicked, this, &MeasuredBar::removeChosen);
    hide();
}

void MeasuredBar::setCurve(const QString& name, const QString& details) {
    whole_ = name;
    name_->setToolTip(details);
    const QSignalBlocker silent(offset_);
    offset_->setValue(0.0);
    setVisible(!name.isEmpty());
    showName();
}

double MeasuredBar::offset() const { return 1e-9 * offset_->value(); }

void MeasuredBar::showName() {
    const QString text = tr("measured: %1").arg(whole_);
    name_->setText(name_->fontMetrics().elidedText(text, Qt::ElideMiddle, name_->width()));
}

void MeasuredBar::resizeEvent(QResizeEvent* /*event*/) { showName(); }

}  // namespace asperity
