#include "app/window/curve/CurveFitForm.h"

#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

#include <numbers>

namespace asperity {

namespace {

constexpr double kTipNanometers = 1e9;
constexpr double kTipDegrees = 180.0 / std::numbers::pi;
constexpr double kLargestTyped = 1e9;

NumberBox* newQuantity(const char* name, const QString& unit, double value, const QString& tip) {
    auto* const box = named(new NumberBox, name, tip);
    box->setDecimals(6);
    box->setRange(0.0, kLargestTyped);
    box->setSuffix(unit);
    box->setValue(value);
    box->setKeyboardTracking(false);
    guardFromWheel(*box);
    return box;
}

/// A value that is the file's where nothing is given.
NumberBox* newGiven(const char* name, const QString& unit, const QString& tip) {
    NumberBox* const box = newQuantity(name, unit, 0.0, tip);
    box->setSpecialValueText(CurveFitForm::tr("of the file"));
    return box;
}

template <class Value>
QComboBox* newKeys(const char* name, const QString& tip) {
    QComboBox* const list = newList(name, tip);
    for (const Value value : kValues<Value>) {
        list->addItem(coreWords(nameOf(value)));
    }
    return list;
}

template <class Value>
Value valueOf(const QComboBox& list) {
    return kValues<Value>[static_cast<std::size_t>(list.currentIndex())];
}

QCheckBox* newCheck(const QString& text, const char* name, bool isOn, const QString& tip) {
    auto* const box = named(new QCheckBox(text), name, tip);
    box->setChecked(isOn);
    return box;
}

/// Tips of the page: those that are no file, after "not known".
constexpr std::array kTips{TipKind::Sphere, TipKind::Paraboloid, TipKind::ConeSphere,
                           TipKind::Cone,   TipKind::Pyramid3,   TipKind::Pyramid4};

}  // namespace

CurveFitForm::CurveFitForm(QWidget* parent)
    : QWidget(parent)
    , tip_(newList("fitTip", tr("Shape of the tip; not known: no modulus, only its product with a "
                                "power of the radius")))
    , radius_(newQuantity("fitRadius", tr(" nm"), 5000.0, tr("Radius of the tip")))
    , angle_(newQuantity("fitAngle", tr(" °"), 20.0, tr("Angle between face and axis")))
    , poisson_(newQuantity("fitPoisson", {}, 0.5, tr("Poisson's ratio of the sample")))
    , film_(newQuantity("fitFilm", tr(" nm"), 0.0,
                        tr("Thickness of the sample on a rigid base, under a paraboloid")))
    , law_(newKeys<SampleLaw>("fitLaw", tr("Contact law")))
    , works_(newList("fitWorks", tr("Works of adhesion; two: one on approach, one on retract")))
    , relaxation_(newCheck(tr("relaxes"), "fitRelaxation", false,
                           tr("The sample relaxes as a standard linear solid; elastic law")))
    , drag_(newCheck(tr("wall drag"), "fitDrag", false,
                     tr("A liquid drags the tip near the sample; elastic law")))
    , branch_(newKeys<FittedBranch>("fitBranch", tr("What is fitted; the rest is predicted")))
    , contact_(newKeys<ContactMethod>("fitContact", tr("Method for the contact point")))
    , lever_(newKeys<LeverRule>(
          "fitLever", tr("Correction of the InvOLS by the contact: none; the spring constant goes "
                         "with it (from a thermal spectrum); or it stays (fixed)")))
    , stiffness_(newGiven("fitStiffness", tr(" N/m"), tr("Spring constant of the lever")))
    , invols_(newGiven("fitInvols", tr(" nm/V"), tr("Inverse optical lever sensitivity")))
    , steps_{
          newCheck(tr("sign"), "stepSign", true,
                   tr("Turn a force over that is negative at the deepest base")),
          newCheck(tr("baseline"), "stepBaseline", true, tr("Take the force before contact off")),
          newCheck(tr("tilt"), "stepTilt", true, tr("of it a line, not a constant")),
          newCheck(tr("drag"), "stepDrag", true,
                   tr("Take the retract's own offset off, which is the lever's drag"))} {
    tip_->addItem(tr("not known"));
    for (const TipKind kind : kTips) {
        tip_->addItem(coreWords(nameOf(kind)));
    }
    works_->addItems({tr("one"), tr("two")});
    film_->setSpecialValueText(tr("thick"));
    poisson_->setRange(0.0, 0.5);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    addTip(*grid);
    addModel(*grid);
    addLever(*grid);
    addSteps(*grid);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    connectParts();
    showPossible();
}

namespace {

void addRow(QGridLayout& grid, const QString& first, QWidget* one, const QString& second,
            QWidget* other) {
    const int row = grid.rowCount();
    grid.addWidget(captionLabel(first, grid.parentWidget()), row, 0);
    grid.addWidget(one, row, 1, 1, other != nullptr ? 1 : 3);
    if (other != nullptr) {
        grid.addWidget(captionLabel(second, grid.parentWidget()), row, 2);
        grid.addWidget(other, row, 3);
    }
}

}  // namespace

void CurveFitForm::addTip(QGridLayout& grid) {
    addRow(grid, tr("Tip"), tip_, tr("Poisson"), poisson_);
    addRow(grid, tr("Radius"), radius_, tr("Angle"), angle_);
    addRow(grid, tr("Film"), film_, tr("Contact"), contact_);
}

void CurveFitForm::addModel(QGridLayout& grid) {
    addRow(grid, tr("Law"), law_, tr("Works"), works_);
    addRow(grid, tr("Sample"), relaxation_, tr("Liquid"), drag_);
    addRow(grid, tr("Fit"), branch_, tr("InvOLS by"), lever_);
}

void CurveFitForm::addLever(QGridLayout& grid) {
    addRow(grid, tr("Spring"), stiffness_, tr("InvOLS"), invols_);
}

void CurveFitForm::addSteps(QGridLayout& grid) {
    addRow(grid, tr("Steps"), newRow({steps_[0], steps_[1], steps_[2], steps_[3]}), {}, nullptr);
}

void CurveFitForm::connectParts() {
    const auto change = [this] {
        showPossible();
        Q_EMIT changed();
    };
    for (QComboBox* const list : {tip_, law_, works_, branch_, contact_, lever_}) {
        connect(list, qOverload<int>(&QComboBox::currentIndexChanged), this, change);
    }
    for (NumberBox* const box : {radius_, angle_, poisson_, film_, stiffness_, invols_}) {
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, change);
    }
    for (QCheckBox* const box : {relaxation_, drag_, steps_[0], steps_[1], steps_[2], steps_[3]}) {
        connect(box, &QCheckBox::toggled, this, change);
    }
}

void CurveFitForm::showPossible() {
    const auto shape = tip();
    radius_->setEnabled(shape && hasRadius(shape->kind));
    angle_->setEnabled(shape && hasAngle(shape->kind));
    film_->setEnabled(shape && shape->kind == TipKind::Paraboloid);
    const bool isElastic = law() == SampleLaw::Elastic;
    relaxation_->setEnabled(isElastic);
    drag_->setEnabled(isElastic);
    works_->setEnabled(law() == SampleLaw::Jkr);
    steps_[2]->setEnabled(steps_[1]->isChecked());
}

std::optional<TipForm> CurveFitForm::tip() const {
    if (tip_->currentIndex() == 0) {
        return std::nullopt;
    }
    const TipKind kind = kTips.at(static_cast<std::size_t>(tip_->currentIndex() - 1));
    return TipForm{.kind = kind,
                   .radius = hasRadius(kind) ? radius_->value() / kTipNanometers : 0.0,
                   .angle = hasAngle(kind) ? angle_->value() / kTipDegrees : 0.0};
}

SampleLaw CurveFitForm::law() const { return valueOf<SampleLaw>(*law_); }

CycleFitOptions CurveFitForm::options() const {
    CycleFitOptions options;
    options.curve.tip = tip();
    options.curve.poissonRatio = poisson_->value();
    options.curve.filmThickness = film_->isEnabled() ? film_->value() / kTipNanometers : 0.0;
    options.curve.contact = valueOf<ContactMethod>(*contact_);
    PreparationOptions& steps = options.curve.preparation;
    steps.lever = valueOf<LeverRule>(*lever_);
    steps.stiffness = stiffness_->value();
    steps.invols = invols_->value() / kTipNanometers;
    steps.sign = steps_[0]->isChecked();
    steps.baseline = steps_[1]->isChecked();
    steps.tilt = steps_[2]->isChecked();
    steps.drag = steps_[3]->isChecked();
    options.law = law();
    options.twoWorks = works_->isEnabled() && works_->currentIndex() == 1;
    options.relaxation = relaxation_->isEnabled() && relaxation_->isChecked();
    options.drag = drag_->isEnabled() && drag_->isChecked();
    options.branch = valueOf<FittedBranch>(*branch_);
    return options;
}

}  // namespace asperity
