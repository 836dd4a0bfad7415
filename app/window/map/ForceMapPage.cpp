#include "app/window/map/ForceMapPage.h"

#include "app/window/map/PixelCurveView.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kPerMeter = 1e9;     // lengths are shown in nanometers
constexpr double kNanonewtons = 1e9;  // forces in nanonewtons
constexpr double kLimit = 1e9;      // of a number that may be typed; the plan refuses what is wrong
constexpr int kMaxTyped = 1000000;  // same, of pixels
constexpr int kUsualPixels = 64;    // along the longer side: some seconds

template <typename Widget>
Widget* guarded(Widget* widget, const char* name, const QString& toolTip) {
    widget->setObjectName(QString::fromLatin1(name));
    widget->setToolTip(toolTip);
    guardFromWheel(*widget);
    return widget;
}

NumberBox* newLength(const char* name, const QString& toolTip, QWidget* parent) {
    auto* box = guarded(new NumberBox(parent), name, toolTip);
    box->setDecimals(6);
    box->setRange(-kLimit, kLimit);
    return box;
}

QSpinBox* newCount(const char* name, const QString& toolTip, QWidget* parent) {
    auto* box = guarded(new QSpinBox(parent), name, toolTip);
    box->setRange(0, kMaxTyped);
    box->setKeyboardTracking(false);
    return box;
}

template <typename Box, typename Value>
void put(Box& box, Value value) {
    const QSignalBlocker blocker(box);
    box.setValue(value);
}

/// A number that was typed as a side of the scan is that side, whatever nanometers round.
double snapped(double end, double side) {
    constexpr double kRounding = 1e-9;
    return std::abs(end - side) <= kRounding * std::max(side, std::abs(end)) ? side : end;
}

constexpr int kFormWidth = 264;  ///< at most [px]

QString titleOf(MapQuantity quantity) { return coreWords(rowOf(quantity)->name); }

}  // namespace

ForceMapForm::ForceMapForm(QWidget* parent)
    : QWidget(parent)
    , mode_(
          guarded(new QComboBox(this), "mapMode",
                  tr("approach: approach and retract at each pixel\ncontact: a raster at constant "
                     "force, trace and retrace")))
    , setpoint_(guarded(new NumberBox(this), "mapSetpoint",
                        tr("Force along z that ends the approach, or is held [nN]; muted: the "
                           "scene's")))
    , area_(guarded(new QComboBox(this), "mapArea", tr("Which part of the scan is mapped")))
    , draw_(pageButton(tr("Draw"), "drawMapRegion",
                       tr("A drag on the whole scan draws the rectangle, or moves it or its sides; "
                          "off, or Esc: a double click travels again"),
                       this))
    , sides_{newLength("mapLeft", tr("Left side of the region, from the left of the scan [nm]"),
                       this),
             newLength("mapRight", tr("Right side of the region, from the left of the scan [nm]"),
                       this),
             newLength("mapBottom",
                       tr("Lower side of the region, from the bottom of the scan "
                          "[nm]"),
                       this),
             newLength("mapTop", tr("Upper side of the region, from the bottom of the scan [nm]"),
                       this)}
    , columns_(newCount("mapColumns", tr("Pixels of a row"), this))
    , rows_(newCount("mapRows", tr("Rows of pixels"), this))
    , instrument_(guarded(new QComboBox(this), "mapInstrument",
                          tr("model: tip, lever and sample as the scene believes them\ntrue "
                             "instrument: as they are in the simulated instrument"))) {
    for (const MapMode mode : kValues<MapMode>) {
        mode_->addItem(QString::fromUtf8(nameOf(mode)));
    }
    area_->addItems({tr("whole scan"), tr("part in view"), tr("rectangle")});
    instrument_->addItems({tr("model"), tr("true instrument")});
    setpoint_->setDecimals(6);
    setpoint_->setRange(-kLimit, kLimit);
    draw_->setCheckable(true);
    addParts();
    connectParts();
}

void ForceMapForm::addParts() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    const auto add = [&](const QString& name, QWidget* first, const QString& between,
                         QWidget* second) {
        const int row = grid->rowCount();
        grid->addWidget(captionLabel(name, this), row, 0);
        grid->addWidget(first, row, 1);
        if (second != nullptr) {
            grid->addWidget(captionLabel(between, this), row, 2);
            grid->addWidget(second, row, 3);
        }
    };
    add(tr("Mode"), mode_, tr("at [nN]"), setpoint_);
    add(tr("Region"), area_, {}, draw_);
    add(tr("x [nm]"), sides_[0], tr("to"), sides_[1]);
    add(tr("y [nm]"), sides_[2], tr("to"), sides_[3]);
    add(tr("Pixels"), columns_, QStringLiteral("×"), rows_);
    add(tr("Source"), instrument_, {}, nullptr);
    grid->setRowStretch(grid->rowCount(), 1);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
}

void ForceMapForm::connectParts() {
    for (QComboBox* const list : {mode_, instrument_}) {
        connect(list, qOverload<int>(&QComboBox::currentIndexChanged), this,
                &ForceMapForm::changed);
    }
    connect(area_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        showRegion();
        draw_->setChecked(area() == Area::Rectangle);
        Q_EMIT changed();
    });
    connect(draw_, &QToolButton::toggled, this, [this](bool drawing) {
        if (drawing && area() != Area::Rectangle) {
            choose(Area::Rectangle);
        }
        Q_EMIT drawingChosen(drawing);
    });
    for (NumberBox* const side : sides_) {
        connect(side, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
                &ForceMapForm::takeFields);
    }
    connect(setpoint_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
        hasOwnSetpoint_ = true;
        setpoint_->setMuted(false);
        Q_EMIT changed();
    });
    for (QSpinBox* const count : {columns_, rows_}) {
        connect(count, qOverload<int>(&QSpinBox::valueChanged), this, [this] {
            hasOwnPixels_ = true;
            Q_EMIT changed();
        });
    }
}

void ForceMapForm::setScan(const QSizeF& size) {
    scan_ = size;
    rectangle_ = {0.0, 0.0, size.width(), size.height()};
    hasOwnPixels_ = false;
    draw_->setChecked(false);
    const QSignalBlocker blocker(area_);
    choose(Area::Whole);
    showRegion();
}

void ForceMapForm::setSetpoint(double force) {
    if (!hasOwnSetpoint_ && setpoint_->value() != kNanonewtons * force) {
        put(*setpoint_, kNanonewtons * force);
        setpoint_->setMuted(true);
        Q_EMIT changed();
    }
}

void ForceMapForm::setView(const QRectF& frame) {
    view_ = frame;
    if (area() == Area::View) {
        showRegion();
        Q_EMIT changed();
    }
}

void ForceMapForm::setRectangle(const QRectF& rectangle) {
    rectangle_ = {rectangle.left(), rectangle.top(), rectangle.right(), rectangle.bottom()};
    {
        const QSignalBlocker blocker(area_);
        choose(Area::Rectangle);
    }
    showRegion();
    Q_EMIT changed();
}

void ForceMapForm::setDrawing(bool drawing) { draw_->setChecked(drawing); }

void ForceMapForm::takeTyped() {
    for (NumberBox* const box : sides_) {
        box->interpretText();
    }
    setpoint_->interpretText();
    columns_->interpretText();
    rows_->interpretText();
}

ForceMapForm::Area ForceMapForm::area() const { return static_cast<Area>(area_->currentIndex()); }

void ForceMapForm::choose(Area area) { area_->setCurrentIndex(static_cast<int>(area)); }

MapRegion ForceMapForm::region() const {
    switch (area()) {
    case Area::View:
        return {std::max(0.0, view_.left()), std::max(0.0, view_.top()),
                std::min(scan_.width(), view_.right()), std::min(scan_.height(), view_.bottom())};
    case Area::Rectangle:
        return rectangle_;
    case Area::Whole:
        break;
    }
    return {0.0, 0.0, scan_.width(), scan_.height()};
}

QRectF ForceMapForm::rectangle() const {
    const MapRegion whole{0.0, 0.0, scan_.width(), scan_.height()};
    return area() != Area::Rectangle || rectangle_ == whole
               ? QRectF()
               : QRectF(QPointF(rectangle_.left, rectangle_.bottom),
                        QPointF(rectangle_.right, rectangle_.top));
}

void ForceMapForm::showRegion() {
    const MapRegion shown = region();
    put(*sides_[0], kPerMeter * shown.left);
    put(*sides_[1], kPerMeter * shown.right);
    put(*sides_[2], kPerMeter * shown.bottom);
    put(*sides_[3], kPerMeter * shown.top);
    suggestPixels();
}

/// A side that is typed makes the region a rectangle.
void ForceMapForm::takeFields() {
    const auto end = [this](std::size_t side, double limit) {
        return snapped(sides_[side]->value() / kPerMeter, limit);
    };
    rectangle_ = {end(0, scan_.width()), end(2, scan_.height()), end(1, scan_.width()),
                  end(3, scan_.height())};
    {
        const QSignalBlocker blocker(area_);
        choose(Area::Rectangle);
    }
    suggestPixels();
    Q_EMIT changed();
}

/// Square ones, as many as take some seconds; those that were typed stay.
void ForceMapForm::suggestPixels() {
    const MapRegion mapped = region();
    const double width = mapped.right - mapped.left;
    const double height = mapped.top - mapped.bottom;
    if (hasOwnPixels_ || !(width > 0.0) || !(height > 0.0)) {
        return;
    }
    const double pitch = std::max(width, height) / kUsualPixels;
    const auto pixels = [pitch](double side) {
        return std::max(1, static_cast<int>(std::lround(side / pitch)));
    };
    put(*columns_, pixels(width));
    put(*rows_, pixels(height));
}

MapRequest ForceMapForm::request() const {
    MapRequest request{.mode = kValues<MapMode>[static_cast<std::size_t>(mode_->currentIndex())],
                       .grid = MapGrid{columns_->value(), rows_->value()},
                       .setpoint = hasOwnSetpoint_
                                       ? std::optional(setpoint_->value() / kNanonewtons)
                                       : std::nullopt,
                       .truth = instrument_->currentIndex() == 1};
    if (area() != Area::Whole) {
        request.region = region();
    }
    return request;
}

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
    state_->setToolTip(tr("Progress of the map, and its scene"));
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
    start_->setToolTip(
        refusal.isEmpty() ? tr("Computes the map in the background; the run continues") : refusal);
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
    const auto found = std::ranges::find(quantities_, shown);
    shown_->setCurrentIndex(
        found == quantities_.end() ? -1 : static_cast<int>(found - quantities_.begin()));
    showButtons();
}

void ForceMapPage::setPicking(bool picking) { pick_->setChecked(picking); }

void ForceMapPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    Q_EMIT shown();
}

}  // namespace asperity
