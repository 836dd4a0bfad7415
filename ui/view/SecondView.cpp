#include "ui/view/SecondView.h"

#include "ui/plot/CopyablePlot.h"
#include "ui/view/ColorScale.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/FlowLayout.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/PageParts.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kSecondViewGap = 6;   // [px]
constexpr int kHeightsLetters = 8;  // of the list of heights: all controls are in one line
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFitting = 0.0;  // see ContactPlot::setHeightFactor()

/// Returns the section as a table: position along the plane from the tip's axis, and world z.
PlotTable tableOf(const std::optional<ContactSection>& section) {
    PlotTable table;
    const auto add = [&table](const QString& name, const std::vector<Vector2>& points) {
        std::vector<double> along;
        std::vector<double> heights;
        for (const Vector2& point : points) {
            along.push_back(point.x());
            heights.push_back(point.y());
        }
        table.add(SecondView::tr("along, %1 [m]").arg(name), along);
        table.add(SecondView::tr("z, %1 [m]").arg(name), heights);
    };
    if (section) {
        add(SecondView::tr("undeformed surface"), section->rest);
        add(SecondView::tr("deformed surface"), section->deformed);
        add(SecondView::tr("tip"), section->tip);
    }
    return table;
}

constexpr int kBarGap = 18;  // [px]

}  // namespace

SecondView::SecondView(QWidget* parent)
    : QWidget(parent)
    , space_(new ZoomView(this))
    , section_(new ContactPlot(this))
    , bars_(new ViewBars(*space_, this))
    , stack_(new QStackedWidget(this))
    , contents_(new QComboBox(this))
    , spaceControls_(new QWidget(this))
    , sectionControls_(new QWidget(this))
    , follows_(pageButton(tr("Auto"), "sectionFollows",
                          tr("The section goes through the contact: it turns with the slope below "
                             "the tip"),
                          this))
    , direction_(new NumberBox(this))
    , heights_(new QComboBox(this)) {
    setObjectName(QStringLiteral("secondView"));
    new CopyablePlot(*section_, [this] { return tableOf(section_->section()); });
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kSecondViewGap);
    auto* controls = new FlowLayout;  // two lines where the view is narrow
    controls->setSpacing(kSecondViewGap);
    addContents();
    controls->addWidget(contents_);
    controls->addWidget(spaceControls_);
    controls->addWidget(sectionControls_);
    controls->addWidget(heights_);
    auto* spaceRow = new QHBoxLayout(spaceControls_);
    auto* sectionRow = new QHBoxLayout(sectionControls_);
    for (QHBoxLayout* row : {spaceRow, sectionRow}) {
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(kSecondViewGap);
    }
    addSpaceControls(*spaceRow);
    addSectionControls(*sectionRow);
    rows->addLayout(controls);
    space_->setAccessibleDescription(
        tr("The sample around the tip, the tip and the force on it, in three dimensions"));
    stack_->addWidget(space_);
    stack_->addWidget(section_);
    rows->addWidget(stack_, 1);
    rows->addWidget(bars_);
    connect(space_, &ZoomView::positionHovered, this, &SecondView::positionHovered);
    connect(space_, &ZoomView::pointerLeft, this, &SecondView::pointerLeft);
    connect(section_, &ContactPlot::positionHovered, this, &SecondView::positionHovered);
    connect(section_, &ContactPlot::pointerLeft, this, &SecondView::pointerLeft);
    setSettings({});
}

void SecondView::addContents() {
    contents_->setObjectName(QStringLiteral("secondContent"));
    contents_->setToolTip(tr("What the second view shows"));
    for (const SecondContent content : kValues<SecondContent>) {
        contents_->addItem(tr(nameOf(content)));
    }
    connect(contents_, qOverload<int>(&QComboBox::activated), this, &SecondView::showContent);
}

void SecondView::addSpaceControls(QHBoxLayout& row) {
    auto* button = new QToolButton(this);
    button->setText(tr("View"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(tr("Height scale, light and drawn elements of this view only"));
    button->setObjectName(QStringLiteral("secondOptions"));
    auto* menu = new QMenu(button);
    options_ = new ViewOptionsMenu(*menu);
    connect(options_, &ViewOptionsMenu::optionsChosen, space_, &ZoomView::setOptions);
    auto* directions = menu->addMenu(tr("&Direction"));
    auto* direction = new DirectionMenu(*directions, DirectionMenu::Keys::None);
    connect(direction, &DirectionMenu::sideChosen, space_, &ZoomView::lookFrom);
    connect(direction, &DirectionMenu::perspectiveChosen, space_, &ZoomView::setPerspective);
    QAction* reset = menu->addAction(tr("&Reset the view"));
    reset->setToolTip(tr("Back to the first direction and width"));
    connect(reset, &QAction::triggered, space_, &ZoomView::resetCamera);
    button->setMenu(menu);
    row.addWidget(button);
}

void SecondView::addSectionControls(QHBoxLayout& row) {
    follows_->setCheckable(true);
    row.addWidget(follows_);
    connect(follows_, &QToolButton::clicked, this, &SecondView::chooseDirection);
    const auto addPreset = [&](const QString& text, double degrees, const QString& toolTip) {
        auto* button = new QToolButton(this);
        button->setText(text);
        button->setToolTip(toolTip);
        row.addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, degrees] {
            direction_->setValue(degrees);
            follows_->setChecked(false);
            chooseDirection();
        });
    };
    addPreset(tr("x"), 0.0, tr("Section along x"));
    addPreset(tr("y"), 90.0, tr("Section along y"));
    direction_->setObjectName(QStringLiteral("sectionDirection"));
    direction_->setDecimals(4);
    direction_->setRange(-180.0, 180.0);
    direction_->setSuffix(QStringLiteral(" °"));
    direction_->setToolTip(
        tr("Direction of the section: from x, counterclockwise as seen from above [°]"));
    row.addWidget(direction_);
    connect(direction_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
        follows_->setChecked(false);
        chooseDirection();
    });
    heights_->setObjectName(QStringLiteral("sectionHeights"));
    heights_->setToolTip(tr("Heights of the section: true to scale, or larger by a factor that the "
                            "section states"));
    heights_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    heights_->setMinimumContentsLength(kHeightsLetters);
    heights_->addItem(tr("True to scale"), 1.0);
    for (const double factor : {2.0, 5.0, 10.0, 20.0, 50.0}) {
        heights_->addItem(tr("Heights ×%1").arg(factor), factor);
    }
    heights_->addItem(tr("Heights fill the plot"), kFitting);
    connect(heights_, qOverload<int>(&QComboBox::activated), this,
            [this] { section_->setHeightFactor(heights_->currentData().toDouble()); });
}

SecondContent SecondView::content() const {
    return kValues<SecondContent>.at(static_cast<std::size_t>(contents_->currentIndex()));
}

void SecondView::showContent() {
    const bool isSpace = content() == SecondContent::Space;
    stack_->setCurrentWidget(isSpace ? static_cast<QWidget*>(space_) : section_);
    spaceControls_->setVisible(isSpace);
    bars_->setVisible(isSpace);
    sectionControls_->setVisible(!isSpace);
    heights_->setVisible(!isSpace);
    useScene(isVisible());
}

/// Only what is seen holds the scene, and meshes of it.
void SecondView::useScene(bool visible) {
    const bool isSpace = content() == SecondContent::Space;
    space_->setScene(visible && isSpace ? scene_ : nullptr);
    section_->setScene(visible && !isSpace ? scene_ : nullptr);
}

void SecondView::setScene(const Scene* scene) {
    scene_ = scene;
    useScene(isVisible());
}

void SecondView::setLook(const SurfaceLook& look, const SurfaceField& field) {
    space_->setLook(look, field);
}

void SecondView::setHalfSpace(const std::shared_ptr<const HalfSpaceAnswer>& answer) {
    space_->setHalfSpace(answer);
    section_->setHalfSpace(answer);
}

void SecondView::setWrittenForce(const std::string& force) {
    space_->setWrittenForce(force);
    section_->setWrittenForce(force);
}

void SecondView::showSnapshot(const Snapshot& snapshot) {
    if (!isVisible()) {
        return;
    }
    if (content() == SecondContent::Space) {
        space_->showSnapshot(snapshot);
    } else {
        section_->showSnapshot(snapshot);
        showFollowedDirection();
    }
}

/// The box names the direction through the contact, too; a number that is being typed stays.
void SecondView::showFollowedDirection() {
    if (follows_->isChecked() && !direction_->hasFocus()) {
        const QSignalBlocker blocker(direction_);
        direction_->setValue(std::round(section_->azimuth() / kDegree));
    }
}

void SecondView::showCrossHair(const std::optional<Vector2>& position,
                               const std::optional<SurfaceReading>& reading) {
    if (isVisible()) {
        space_->showCrossHair(position);
        section_->showCrossHair(position, reading);
    }
}

void SecondView::chooseDirection() {
    section_->setAzimuth(follows_->isChecked() ? std::nullopt
                                               : std::optional(kDegree * direction_->value()));
}

SecondViewSettings SecondView::settings() const {
    return {.content = content(),
            .options = options_->options(),
            .followsContact = follows_->isChecked(),
            .azimuth = direction_->value(),
            .heightFactor = heights_->currentData().toDouble()};
}

void SecondView::setSettings(const SecondViewSettings& settings) {
    contents_->setCurrentIndex(static_cast<int>(settings.content));
    options_->setOptions(settings.options);
    space_->setOptions(settings.options);
    direction_->setValue(settings.azimuth);
    follows_->setChecked(settings.followsContact);
    const int known = heights_->findData(settings.heightFactor);
    heights_->setCurrentIndex(std::max(0, known));
    section_->setHeightFactor(heights_->currentData().toDouble());
    chooseDirection();
    showContent();
}

void SecondView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    useScene(true);
}

void SecondView::hideEvent(QHideEvent* event) {
    useScene(false);
    QWidget::hideEvent(event);
}

ViewBars::ViewBars(const ZoomView& view, QWidget* parent)
    : QWidget(parent)
    , quantity_(new ColorBarWidget(this))
    , displacement_(new ColorBarWidget(this))
    , dentOnly_(pageButton(tr("Dent only"), "dentOnly",
                           tr("Colors the surface by its displacement alone, so that dent and neck "
                              "stand out; off: by its height again"),
                           this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBarGap);
    for (ColorBarWidget* bar : {quantity_, displacement_}) {
        row->addWidget(bar);
        connect(bar, &QWidget::customContextMenuRequested, this,
                [this, bar](const QPoint& at) { Q_EMIT colorsRequested(bar->mapToGlobal(at)); });
    }
    dentOnly_->setCheckable(true);
    row->addWidget(dentOnly_);
    connect(dentOnly_, &QToolButton::clicked, this, &ViewBars::dentOnlyChosen);
    connect(&view, &ZoomView::scalesChanged, this, [this, &view] { showScales(view); });
    showScales(view);
}

void ViewBars::setDentOnly(bool isOnly) { dentOnly_->setChecked(isOnly); }

void ViewBars::showScales(const ZoomView& view) {
    const ColorScale quantity = view.colorScale();
    const ColorScale displacement = view.displacementScale();
    quantity_->setScale(quantity);
    displacement_->setScale(displacement);
    displacement_->setHidden(!quantity.colors.empty() && displacement.colors.empty());
}

CrossHairLink::CrossHairLink(ZoomView& view, SecondView& second, OverviewMap& map)
    : view_(view), second_(second), map_(map) {
    follow(view);
    follow(second);
    follow(map);
    connect(&view, &ZoomView::readingChanged, this, &CrossHairLink::showInOthers);
}

template <class View>
void CrossHairLink::follow(View& view) {
    connect(&view, &View::positionHovered, this,
            [this](double x, double y) { point(Vector2(x, y)); });
    connect(&view, &View::pointerLeft, this, [this] { point(std::nullopt); });
}

void CrossHairLink::point(const std::optional<Vector2>& position) {
    const std::optional<Vector2> shown = isOn_ ? position : std::nullopt;
    if (shown != position_) {
        position_ = shown;
        view_.showCrossHair(shown);
        showInOthers();
    }
}

void CrossHairLink::setOn(bool on) {
    isOn_ = on;
    point(position_);
}

void CrossHairLink::showInOthers() {
    const std::optional<SurfaceReading> read = position_ ? view_.reading(*position_) : std::nullopt;
    second_.showCrossHair(position_, read);
    map_.showCrossHair(position_ ? std::optional(QPointF(position_->x(), position_->y()))
                                 : std::nullopt,
                       read ? textOf(*read) : QString());
}

}  // namespace asperity
