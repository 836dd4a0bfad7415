#include "ui/panels/StateBanner.h"

#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/words/ModelWords.h"
#include "ui/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>

#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kHeight = 32;        ///< [px]
constexpr double kFlagHold = 0.5;  ///< how long a flag stays shown [s of physics time]
constexpr double kNever = -std::numeric_limits<double>::infinity();

template <class Value>
QString wordsOf(Value value) {
    return QString::fromUtf8(nameOf(value));
}

bool actsFully(ForceState state) { return state == ForceState::On || state == ForceState::Limited; }

}  // namespace

StateBanner::StateBanner(QWidget* parent)
    : QFrame(parent)
    , state_(new QLabel(this))
    , flags_(new QLabel(this))
    , rearm_(new QPushButton(QStringLiteral("Take back"), this)) {
    setObjectName(QStringLiteral("stateBanner"));
    setFixedHeight(kHeight);
    state_->setObjectName(QStringLiteral("state"));
    state_->setTextFormat(Qt::PlainText);
    state_->setFont(theme::boldFont(theme::kTextSize + 1));
    flags_->setObjectName(QStringLiteral("flags"));
    flags_->setTextFormat(Qt::PlainText);
    flags_->setFont(theme::textFont());
    flags_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    flags_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    QPalette palette = flags_->palette();
    palette.setColor(QPalette::WindowText, theme::kCaution);
    flags_->setPalette(palette);
    rearm_->setObjectName(QStringLiteral("rearm"));
    rearm_->setToolTip(QStringLiteral("Take back the fault: forces act again"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 2, 10, 2);
    layout->setSpacing(12);
    layout->addWidget(state_);
    layout->addWidget(flags_, 1);
    layout->addWidget(rearm_);
    connect(rearm_, &QPushButton::clicked, this, &StateBanner::rearmRequested);
    clear();
}

void StateBanner::take(const TickSample& sample) noexcept {
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        if (sample.output.flags.has(kValidityTraits.at(i).flag)) {
            lastSeen_.at(i) = sample.time;
        }
    }
}

void StateBanner::show(const Snapshot& snapshot) {
    latest_ = snapshot;
    hasRun_ = true;
    showState();
    showFlags();
}

void StateBanner::setHalfSpace(const HalfSpaceAnswer* answer) {
    halfSpace_.clear();
    notHolding_.clear();
    // Far from the sample there is nothing to solve, and nothing wrong.
    if (answer != nullptr && answer->verdict != HalfSpaceVerdict::NotBonded) {
        (answer->valid() ? halfSpace_ : notHolding_) = QString::fromStdString(sentenceOf(*answer));
    }
}

void StateBanner::setPaused(bool paused) {
    paused_ = paused;
    showState();
}

void StateBanner::clear() {
    latest_ = {};
    hasRun_ = false;
    lastSeen_.fill(kNever);
    setHalfSpace(nullptr);
    setEnergyGiven(false);
    showState();
    showFlags();
}

QString StateBanner::stateWords() const {
    const TickOutput& output = latest_.sample.output;
    if (output.fault != Fault::None) {
        return QStringLiteral("fault: ") + wordsOf(output.fault);
    }
    if (!hasRun_) {
        return paused_ ? QStringLiteral("paused") : QStringLiteral("not started");
    }
    QStringList words;
    if (paused_) {
        words << QStringLiteral("paused");
    }
    if (const QString force = wordsOf(output.forceState); !force.isEmpty()) {
        words << force;
    }
    const TickInput& input = latest_.sample.input;
    if (!edgeForce(input.settings.workspace, input.device.position).isZero(0.0)) {
        words << QStringLiteral("edge of the workspace: clutch (C)");
    }
    words << wordsOf(output.region());
    if (!halfSpace_.isEmpty()) {
        words << halfSpace_;
    }
    return words.join(QStringLiteral(" · "));
}

QRgb StateBanner::stateColor() const {
    const TickOutput& output = latest_.sample.output;
    if (output.fault != Fault::None) {
        return theme::kFault;
    }
    if (paused_ || !hasRun_) {
        return theme::kMuted;
    }
    if (!actsFully(output.forceState)) {
        return theme::kCaution;
    }
    switch (output.region()) {
    case TipRegion::Far:
        return theme::kTip;
    case TipRegion::Cohesive:
        return theme::kOrange;
    case TipRegion::Contact:
        return theme::kGreen;
    }
    return theme::kInk;
}

void StateBanner::showState() {
    state_->setText(stateWords());
    rearm_->setVisible(latest_.sample.output.fault != Fault::None);
    const QRgb color = stateColor();
    if (color == shownColor_) {
        return;  // style sheets are slow to set
    }
    shownColor_ = color;
    QColor wash(color);
    wash.setAlphaF(0.12);
    setStyleSheet(QStringLiteral("#stateBanner { background: %1; border: none; border-left: 5px "
                                 "solid %2; border-radius: 4px; } #state { color: %3; }")
                      .arg(wash.name(QColor::HexArgb), QColor(color).name(),
                           QColor(color).darker(125).name()));
}

bool StateBanner::isShown(std::size_t index) const {
    const ValidityTraits& flag = kValidityTraits.at(index);
    const double age = latest_.sample.time - lastSeen_.at(index);
    // A notice of what is to come is void when it has come.
    const bool lingers = flag.severity != Severity::Notice && age >= 0.0 && age < kFlagHold;
    return lingers || latest_.sample.output.flags.has(flag.flag);
}

void StateBanner::showFlags() {
    QStringList words;
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        if (isShown(i)) {
            words << QString::fromLatin1(kValidityTraits.at(i).words);
        }
    }
    if (energyGiven_) {
        words << QStringLiteral("hand and device begin to shake: hold firmer, or turn the force "
                                "gain down");
    }
    if (!notHolding_.isEmpty()) {
        words << notHolding_;
    }
    const QString whole = words.join(QStringLiteral(" · "));
    if (whole != caution_) {
        caution_ = whole;
        flags_->setToolTip(words.join(QLatin1Char('\n')));
    }
    flags_->setText(flags_->fontMetrics().elidedText(caution_, Qt::ElideRight, flags_->width()));
}

void StateBanner::resizeEvent(QResizeEvent* /*event*/) { showFlags(); }

}  // namespace asperity
