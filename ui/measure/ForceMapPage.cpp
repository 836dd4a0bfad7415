#include "ui/measure/ForceMapPage.h"

#include "ui/CoreWords.h"
#include "ui/Theme.h"
#include "ui/measure/ForceMapForm.h"
#include "ui/measure/PageParts.h"
#include "ui/measure/PixelCurveView.h"
#include "ui/panels/Card.h"
#include "ui/panels/WheelGuard.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kFormWidth = 264;  ///< at most [px]

QString titleOf(MapQuantity quantity) { return coreWords(rowOf(quantity)->name); }

}  // namespace

ForceMapPage::ForceMapPage(QWidget* parent)
    : QWidget(parent)
    , form_(new ForceMapForm(this))
    , pixel_(new PixelCurveView(this))
    , start_(pageButton(tr("Start"), "startMap", {}, this))
    , cancel_(pageButton(tr("Cancel"), "cancelMap",
                         tr("Ends the map; the rows that are finished stay"), this))
    , pick_(pageButton(tr("Pick a pixel"), "pickPixel",
                       tr("A click on the map, on the whole scan, shows the force curve of that "
                          "pixel; off, or Esc: a double click travels again"),
                       this))
    , save_(pageButton(tr("Save…"), "saveMap",
                       tr("Writes the map as asperity map does: .gwy, .vti, .exr and pictures"),
                       this))
    , shown_(new QComboBox(this))
    , estimate_(captionLabel(QString(), this))
    , refusal_(captionLabel(QString(), this))
    , state_(captionLabel(QString(), this)) {
    setToolTip(tr("Adhesion, stiffness, deformation and friction over the scan or a part of it"));
    start_->setFocusPolicy(Qt::StrongFocus);  // a number that is typed half counts by then
    pick_->setCheckable(true);
    shown_->setObjectName(QStringLiteral("mapQuantity"));
    shown_->setToolTip(tr("The quantity of the map that colors the surface"));
    shown_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    guardFromWheel(*shown_);
    state_->setObjectName(QStringLiteral("mapState"));
    state_->setToolTip(tr("How far the map is, and what it is of"));
    state_->setWordWrap(true);
    state_->hide();
    estimate_->setObjectName(QStringLiteral("mapEstimate"));
    estimate_->setToolTip(tr("By the time that some pixels in the middle of the map took"));
    refusal_->setObjectName(QStringLiteral("mapRefusal"));
    refusal_->setToolTip(tr("Why there is no such map"));
    refusal_->setTextFormat(Qt::PlainText);
    theme::colorText(*refusal_, &ThemeColors::fault);
    for (QLabel* const words : {estimate_, refusal_}) {
        words->setWordWrap(true);
    }
    refusal_->hide();
    form_->setMaximumWidth(theme::scaled(kFormWidth));
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addWidget(form_);
    middle->addWidget(pixel_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 2, 6, 2);
    column->setSpacing(3);
    column->addWidget(newBar());
    column->addLayout(middle, 1);
    connectParts();
    setQuantities({}, MapQuantity::AdhesionForce);
    pixel_->clear({});
}

QWidget* ForceMapPage::newBar() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(start_);
    row->addWidget(cancel_);
    row->addSpacing(8);
    row->addWidget(shown_);
    row->addWidget(pick_);
    row->addWidget(save_);
    row->addSpacing(8);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    for (QLabel* const line : {state_, estimate_, refusal_}) {
        words->addWidget(line);
    }
    row->addLayout(words, 1);
    return bar;
}

void ForceMapPage::connectParts() {
    connect(start_, &QToolButton::clicked, this, [this] {
        form_->takeTyped();
        if (start_->isEnabled()) {
            Q_EMIT startChosen();
        }
    });
    connect(cancel_, &QToolButton::clicked, this, &ForceMapPage::cancelChosen);
    connect(save_, &QToolButton::clicked, this, &ForceMapPage::saveChosen);
    connect(pick_, &QToolButton::toggled, this, &ForceMapPage::pickingChosen);
    connect(shown_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
        if (index >= 0) {
            Q_EMIT quantityChosen(quantities_[static_cast<std::size_t>(index)]);
        }
    });
}

void ForceMapPage::setRefusal(const QString& reason) {
    refusal_->setText(reason);
    refusal_->setVisible(!reason.isEmpty());
    estimate_->setVisible(reason.isEmpty());
    showButtons();
}

void ForceMapPage::setEstimate(const QString& words) { estimate_->setText(words); }

void ForceMapPage::setRunning(bool running) {
    running_ = running;
    showButtons();
}

void ForceMapPage::showButtons() {
    const bool hasMap = !quantities_.empty();
    const QString refusal = refusal_->text();
    start_->setEnabled(!running_ && refusal.isEmpty());
    start_->setToolTip(refusal.isEmpty() ? tr("Computes the map in the background; the run goes on")
                                         : refusal);
    cancel_->setEnabled(running_);
    form_->setEnabled(!running_);
    shown_->setEnabled(hasMap);
    pick_->setEnabled(hasMap);
    save_->setEnabled(hasMap && !running_);
}

void ForceMapPage::setState(const QString& words) {
    state_->setText(words);
    state_->setVisible(!words.isEmpty());
}

QString ForceMapPage::state() const { return state_->text(); }

void ForceMapPage::setQuantities(const std::vector<MapQuantity>& quantities, MapQuantity shown) {
    quantities_ = quantities;
    const QSignalBlocker blocker(shown_);
    shown_->clear();
    for (const MapQuantity quantity : quantities) {
        shown_->addItem(titleOf(quantity));
    }
    const auto place = std::ranges::find(quantities_, shown);
    shown_->setCurrentIndex(
        place == quantities_.end() ? -1 : static_cast<int>(place - quantities_.begin()));
    showButtons();
}

void ForceMapPage::setPicking(bool picking) { pick_->setChecked(picking); }

void ForceMapPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    Q_EMIT shown();
}

}  // namespace asperity
