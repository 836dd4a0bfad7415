#include "ui/window/SecondView.h"

#include "ui/panels/CopyablePlot.h"
#include "ui/panels/FlowLayout.h"
#include "ui/panels/NumberBox.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/ZoomView.h"
#include "ui/window/DirectionMenu.h"
#include "ui/window/ViewBars.h"
#include "ui/window/ViewOptionsMenu.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kSecondViewGap = 6;  // [px]
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFitting = 0.0;  // see ContactPlot::setHeightFactor()

/// What the section shows: place along the plane from the tip's axis, and world z.
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
        add(SecondView::tr("surface at rest"), section->rest);
        add(SecondView::tr("deformed surface"), section->deformed);
        add(SecondView::tr("tip"), section->tip);
    }
    return table;
}

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
    connect(space_, &ZoomView::placeHovered, this, &SecondView::placeHovered);
    connect(space_, &ZoomView::placeLeft, this, &SecondView::placeLeft);
    connect(section_, &ContactPlot::placeHovered, this, &SecondView::placeHovered);
    connect(section_, &ContactPlot::placeLeft, this, &SecondView::placeLeft);
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
    button->setToolTip(tr("Height scale, light and what is drawn, of this view alone"));
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
    const auto addPreset = [&](const QString& text, double degrees, const QString& toolTip) {
        auto* button = new QToolButton(this);
        button->setText(text);
        button->setToolTip(toolTip);
        row.addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, degrees] {
            direction_->setValue(degrees);
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
    connect(direction_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &SecondView::chooseDirection);
    heights_->setObjectName(QStringLiteral("sectionHeights"));
    heights_->setToolTip(tr("Heights of the section: true to scale, or larger by a factor that the "
                            "section states"));
    heights_->addItem(tr("True to scale"), 1.0);
    for (const double factor : {2.0, 5.0, 10.0, 20.0, 50.0}) {
        heights_->addItem(tr("Heights ×%1").arg(factor), factor);
    }
    heights_->addItem(tr("Heights fill the plot"), kFitting);
    row.addWidget(heights_);
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
    }
}

void SecondView::showCrossHair(const std::optional<Vector2>& place,
                               const std::optional<SurfaceReading>& reading) {
    if (isVisible()) {
        space_->showCrossHair(place);
        section_->showCrossHair(place, reading);
    }
}

void SecondView::chooseDirection() { section_->setAzimuth(kDegree * direction_->value()); }

SecondViewSettings SecondView::settings() const {
    return {.content = content(),
            .options = options_->options(),
            .azimuth = direction_->value(),
            .heightFactor = heights_->currentData().toDouble()};
}

void SecondView::setSettings(const SecondViewSettings& settings) {
    contents_->setCurrentIndex(static_cast<int>(settings.content));
    options_->setOptions(settings.options);
    space_->setOptions(settings.options);
    direction_->setValue(settings.azimuth);
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

}  // namespace asperity
