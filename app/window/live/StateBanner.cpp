#include "app/window/live/StateBanner.h"

#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/scene/Validity.h"
#include "core/words/ModelWords.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QToolTip>

#include <algorithm>
#include <limits>

namespace asperity {

namespace {

constexpr double kHold = 0.5;    ///< how long a flag stays shown [s of physics time]
constexpr double kWindow = 0.5;  ///< of the share of ticks, exponentially weighted [s]
constexpr double kMax = 0.5;     ///< share of ticks from which noise is no excuse
constexpr double kFew = 0.25;    ///< share below which it is one again
constexpr double kNever = -std::numeric_limits<double>::infinity();

constexpr int kHeight = 32;             ///< [px]
constexpr int kEdge = 5;                ///< in the state's full color, at the left [px]
constexpr double kBannerRadius = 4.0;   ///< of the corners [px]
constexpr double kWash = 0.12;          ///< of the state's color behind the words
constexpr double kRecordedWash = 0.35;  ///< the same, of a recording: no live run looks so
constexpr int kMaxBannerLetters = 60;   ///< of the whole line
constexpr double kStateSize = 9.75;     ///< of letters [pt]
const QString kBetween = QStringLiteral(" · ");

template <class Value>
QString wordsOf(Value value) {
    return coreWords(nameOf(value));
}

QString recordingWords(double time) {
    return StateBanner::tr("Recording, t = %1 s").arg(time, 0, 'f', 3);
}

bool actsFully(ForceState state) { return state == ForceState::On || state == ForceState::Limited; }

}  // namespace

void ShownFlags::clear() noexcept {
    seen_.fill({.last = kNever});
    time_.reset();
}

void ShownFlags::take(const TickSample& sample) noexcept {
    const double step = std::clamp(sample.time - time_.value_or(sample.time), 0.0, kWindow);
    time_ = sample.time;
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        Seen& seen = seen_.at(i);
        const bool has = sample.output.flags.has(kValidityTraits.at(i).flag);
        if (has) {
            seen.last = sample.time;
        }
        seen.share += ((has ? 1.0 : 0.0) - seen.share) * step / kWindow;
        seen.inMost = seen.share > (seen.inMost ? kFew : kMax);
    }
}

bool ShownFlags::isShown(std::size_t index, const TickSample& latest) const {
    const ValidityTraits& flag = kValidityTraits.at(index);
    const Seen& seen = seen_.at(index);
    if (flag.basis == FlagBasis::Signals) {
        return seen.inMost;
    }
    const double age = latest.time - seen.last;
    // A notice of what is to come is void when it has come.
    const bool isOver =
        flag.severity == Severity::Notice ||
        (flag.basis == FlagBasis::Contact && latest.output.region() == TipRegion::Far);
    const bool lingers = !isOver && age >= 0.0 && age < kHold;
    return lingers || latest.output.flags.has(flag.flag);
}

StateBanner::StateBanner(QWidget* parent)
    : QFrame(parent)
    , state_(new QLabel(this))
    , flags_(new QLabel(this))
    , rearm_(new QPushButton(tr("Reset fault"), this)) {
    setObjectName(QStringLiteral("stateBanner"));
    setFixedHeight(theme::scaled(kHeight));
    state_->setObjectName(QStringLiteral("state"));
    state_->setTextFormat(Qt::PlainText);
    state_->setFont(theme::boldFont(kStateSize));
    flags_->setObjectName(QStringLiteral("flags"));
    flags_->setTextFormat(Qt::PlainText);
    flags_->setFont(theme::textFont());
    flags_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    flags_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    theme::colorText(*flags_, &ThemeColors::caution);
    rearm_->setObjectName(QStringLiteral("rearm"));
    rearm_->setToolTip(tr("Reset the fault: forces act again"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 2, 10, 2);
    layout->setSpacing(12);
    layout->addWidget(state_);
    layout->addWidget(flags_, 1);
    layout->addWidget(rearm_);
    connect(rearm_, &QPushButton::clicked, this, &StateBanner::rearmRequested);
    clear();
    theme::follow(this, [this] { showColor(); });
}

void StateBanner::take(const TickSample& sample) noexcept { shown_.take(sample); }

void StateBanner::show(const Snapshot& snapshot) {
    latest_ = snapshot;
    hasRun_ = true;
    showLine();
}

void StateBanner::setHalfSpace(const HalfSpaceAnswer* answer) {
    halfSpace_.clear();
    notHolding_.clear();
    // Far from the sample there is nothing to solve, and nothing wrong.
    if (answer != nullptr && answer->verdict != HalfSpaceVerdict::NotBonded) {
        (answer->valid() ? halfSpace_ : notHolding_) = coreWords(sentenceOf(*answer));
    }
}

void StateBanner::setPaused(bool paused) {
    paused_ = paused;
    showLine();
}

void StateBanner::setRecorded(const std::optional<double>& time) {
    recorded_ = time;
    showLine();
}

void StateBanner::clear() {
    latest_ = {};
    hasRun_ = false;
    shown_.clear();
    setHalfSpace(nullptr);
    setEnergyGiven(false);
    showLine();
}

QStringList StateBanner::stateWords() const {
    const TickOutput& output = latest_.sample.output;
    if (output.fault != Fault::None) {
        const QString fault = tr("fault: %1").arg(wordsOf(output.fault));
        return recorded_ ? QStringList{recordingWords(*recorded_), fault} : QStringList{fault};
    }
    if (!hasRun_) {
        return {paused_ ? tr("paused") : tr("not started")};
    }
    QStringList words;
    if (recorded_) {
        words << recordingWords(*recorded_);
    } else if (paused_) {
        words << tr("paused");
    }
    if (const QString force = wordsOf(output.forceState); !recorded_ && !force.isEmpty()) {
        words << force;
    }
    const TickInput& input = latest_.sample.input;
    if (!recorded_ && !edgeForce(input.settings.workspace, input.device.position).isZero(0.0)) {
        words << tr("edge of the workspace: clutch (C)");
    }
    return words << wordsOf(output.region());
}

std::vector<StateBanner::Caution> StateBanner::cautions() const {
    std::vector<Caution> found;
    if (energyGiven_) {
        found.push_back(
            {tr("device begins to oscillate"),
             tr("device begins to oscillate: hold it more firmly or reduce the force gain"),
             Severity::Invalid});
    }
    for (const Validity one : kFlagsByEffect) {
        if (shown_.isShown(indexOf(one), latest_.sample)) {
            const ValidityTraits& flag = traitsOf(one);
            found.push_back({coreWords(flag.brief), coreWords(flag.words), flag.severity});
        }
    }
    if (!notHolding_.isEmpty()) {
        found.push_back({tr("closed form shown"), notHolding_, Severity::Approximate});
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &Caution::severity);
    return found;
}

void StateBanner::showLine() {
    const QStringList whole = stateWords();
    const std::vector<Caution> all = cautions();
    QString caution = all.empty() ? QString() : all.front().brief;
    if (all.size() > 1) {
        caution += tr(" +%1").arg(all.size() - 1);
    }
    QStringList state = whole;
    const auto isTooLong = [&] {
        const int between = caution.isEmpty() ? 0 : kBetween.size();
        return state.join(kBetween).size() + between + caution.size() > kMaxBannerLetters;
    };
    // The color says where the tip is, if the words cannot.
    while (state.size() > 1 && isTooLong()) {
        state.removeLast();
    }
    if (isTooLong()) {
        caution.clear();
    }
    state_->setText(state.join(kBetween));
    flags_->setText(flags_->fontMetrics().elidedText(caution, Qt::ElideRight, flags_->width()));
    rearm_->setVisible(!recorded_ && latest_.sample.output.fault != Fault::None);
    showDetails(whole, all);
    showColor();
}

void StateBanner::showDetails(const QStringList& state, const std::vector<Caution>& cautions) {
    QStringList details{state.join(kBetween)};
    if (!halfSpace_.isEmpty()) {
        details << halfSpace_;
    }
    for (const Caution& caution : cautions) {
        details << caution.words;
    }
    const QString text = details.join(QLatin1Char('\n'));
    if (text != details_) {
        details_ = text;
        setToolTip(text);
    }
}

QColor StateBanner::stateColor() const {
    const TickOutput& output = latest_.sample.output;
    if (recorded_) {
        return theme::colors().purple;
    }
    if (output.fault != Fault::None) {
        return theme::colors().fault;
    }
    if (paused_ || !hasRun_) {
        return theme::colors().muted;
    }
    if (!actsFully(output.forceState)) {
        return theme::colors().caution;
    }
    switch (output.region()) {
    case TipRegion::Far:
        return theme::colors().tip;
    case TipRegion::Cohesive:
        return theme::colors().orange;
    case TipRegion::Contact:
        return theme::colors().green;
    }
    return theme::colors().ink;
}

void StateBanner::showColor() {
    if (const QColor color = stateColor(); color != shownColor_) {
        shownColor_ = color;
        update();
    }
}

void StateBanner::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QPainterPath shape;
    shape.addRoundedRect(rect(), kBannerRadius, kBannerRadius);
    painter.setClipPath(shape);
    QColor wash = shownColor_;
    wash.setAlphaF(recorded_ ? kRecordedWash : kWash);
    painter.fillRect(rect(), wash);
    painter.fillRect(0, 0, kEdge, height(), shownColor_);
}

void StateBanner::resizeEvent(QResizeEvent* /*event*/) { showLine(); }

void StateBanner::mousePressEvent(QMouseEvent* event) { event->accept(); }

// A tool tip that a press shows would vanish with the release.
void StateBanner::mouseReleaseEvent(QMouseEvent* event) {
    QToolTip::showText(event->globalPos(), details_, this);
}

}  // namespace asperity
