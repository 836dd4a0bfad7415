#include "ui/panels/ScaleForm.h"

#include "core/SiFormat.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/LengthBox.h"
#include "ui/panels/RefusalLine.h"
#include "ui/panels/WheelGuard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr int kGap = 8;        // [px]
constexpr int kBoxWidth = 90;  // [px]

struct LengthUnit {
    const char* name;
    double meters;
};
constexpr std::array kSizeUnits = {LengthUnit{"nm", 1e-9}, LengthUnit{"µm", 1e-6},
                                   LengthUnit{"mm", 1e-3}, LengthUnit{"m", 1.0}};
constexpr std::array kHeightUnits = {LengthUnit{"pm", 1e-12}, LengthUnit{"Å", 1e-10},
                                     LengthUnit{"nm", 1e-9},  LengthUnit{"µm", 1e-6},
                                     LengthUnit{"mm", 1e-3},  LengthUnit{"m", 1.0}};

QComboBox* newUnitBox(const auto& units, const char* usual, QWidget* parent) {
    auto* box = new QComboBox(parent);
    for (const LengthUnit& unit : units) {
        box->addItem(QString::fromUtf8(unit.name), unit.meters);
    }
    box->setCurrentText(QString::fromUtf8(usual));
    guardFromWheel(*box);
    return box;
}

LengthBox* newLengthBox(const char* name, const QString& tip, QWidget* parent) {
    auto* box = new LengthBox(parent);
    box->setObjectName(QString::fromUtf8(name));
    box->setToolTip(tip);
    box->setMinimumWidth(theme::scaled(kBoxWidth));
    guardFromWheel(*box);
    return box;
}

double metersOf(const QComboBox& unit) { return unit.currentData().toDouble(); }

/// The largest unit of which a length is at least one. @param length [m]
void chooseUnit(QComboBox& unit, double length) {
    constexpr double kRounding = 1e-9;
    for (int i = 0; i < unit.count(); ++i) {
        if (i == 0 || length >= unit.itemData(i).toDouble() * (1.0 - kRounding)) {
            unit.setCurrentIndex(i);
        }
    }
}

double lengthIn(const LengthBox& box, const QComboBox& unit) {
    return box.isBlank() ? 0.0 : inMeters(box.value(), metersOf(unit));
}

QString missingText(const ScaleGap& gap) {
    const QString isMask = gap.mask ? ScaleForm::tr("This is a mask, not heights. ") : QString();
    if (gap.size && gap.height) {
        return isMask + ScaleForm::tr("The file holds neither the size of the scan nor the unit of "
                                      "its values.");
    }
    return isMask + (gap.size ? ScaleForm::tr("The file does not hold the size of the scan.")
                              : ScaleForm::tr("The file does not hold the unit of its values."));
}

/// Fields of their own, so that they go together.
QGridLayout* newFields(QWidget& part) {
    auto* grid = new QGridLayout(&part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kGap);
    grid->setColumnStretch(1, 1);
    return grid;
}

}  // namespace

ScaleForm::ScaleForm(Qt::Orientation orientation, QWidget* parent)
    : QWidget(parent)
    , missing_(new QLabel(this))
    , size_(new QWidget(this))
    , height_(new QWidget(this))
    , sizeX_(newLengthBox("sizeX", tr("Length of the whole scan along x, the fast axis"), size_))
    , sizeY_(newLengthBox("sizeY", tr("Length of the whole scan along y, the slow axis"), size_))
    , sizeUnit_(newUnitBox(kSizeUnits, "µm", size_))
    , square_(new QCheckBox(tr("Square pixels"), size_))
    , heightPerValue_(newLengthBox("heightPerValue",
                                   tr("Height that a value of 1 in the file stands for"), height_))
    , heightUnit_(newUnitBox(kHeightUnits, "nm", height_))
    , pixel_(captionLabel({}, size_)) {
    missing_->setTextFormat(Qt::PlainText);
    missing_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    column->addWidget(missing_);
    addSize(*newFields(*size_));
    addHeight(*newFields(*height_));
    auto* fields = new QBoxLayout(orientation == Qt::Vertical ? QBoxLayout::TopToBottom
                                                              : QBoxLayout::LeftToRight);
    fields->setSpacing(kGap);
    fields->addWidget(size_, 0, Qt::AlignTop);
    fields->addWidget(height_, 0, Qt::AlignTop);
    column->addLayout(fields);
    column->addWidget(new RefusalLine(this));
    connectInputs();
    setGap({});
}

void ScaleForm::addSize(QGridLayout& grid) {
    sizeUnit_->setObjectName(QStringLiteral("sizeUnit"));
    sizeUnit_->setToolTip(tr("Unit of both sides of the scan"));
    square_->setObjectName(QStringLiteral("squarePixels"));
    square_->setToolTip(tr("One side follows from the other by the numbers of pixels"));
    square_->setChecked(true);
    pixel_->setObjectName(QStringLiteral("pixelSize"));
    pixel_->setToolTip(tr("Width and height of a pixel that follow"));
    grid.addWidget(captionLabel(tr("Scan size along x"), size_), 0, 0);
    grid.addWidget(sizeX_, 0, 1);
    grid.addWidget(sizeUnit_, 0, 2);
    grid.addWidget(captionLabel(tr("Scan size along y"), size_), 1, 0);
    grid.addWidget(sizeY_, 1, 1);
    grid.addWidget(square_, 1, 2);
    grid.addWidget(pixel_, 2, 1, 1, 2);
}

void ScaleForm::addHeight(QGridLayout& grid) {
    heightUnit_->setObjectName(QStringLiteral("heightUnit"));
    heightUnit_->setToolTip(tr("Unit of the height of a value of 1"));
    grid.addWidget(captionLabel(tr("A value of 1 is a height of"), height_), 0, 0);
    grid.addWidget(heightPerValue_, 0, 1);
    grid.addWidget(heightUnit_, 0, 2);
}

void ScaleForm::connectInputs() {
    for (LengthBox* const box : {sizeX_, sizeY_, heightPerValue_}) {
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, box] {
            follow(*box);
            showState();
        });
        connect(box->findChild<QLineEdit*>(), &QLineEdit::textChanged, this, &ScaleForm::showState);
        connect(box, &NumberBox::refused, this, &ScaleForm::showState);
    }
    connect(square_, &QCheckBox::toggled, this, [this] {
        follow(sizeX_->isBlank() ? *sizeY_ : *sizeX_);
        showState();
    });
    for (const QComboBox* const unit : {sizeUnit_, heightUnit_}) {
        connect(unit, qOverload<int>(&QComboBox::currentIndexChanged), this, &ScaleForm::showState);
    }
}

void ScaleForm::follow(const LengthBox& entered) {
    if (!square_->isChecked() || &entered == heightPerValue_ || entered.isBlank()) {
        return;
    }
    const bool isX = &entered == sizeX_;
    const double aspect = static_cast<double>(gap_.rows) / gap_.columns;
    LengthBox& other = isX ? *sizeY_ : *sizeX_;
    const QSignalBlocker blocker(other);
    other.setValue(entered.value() * (isX ? aspect : 1.0 / aspect));
}

void ScaleForm::setGap(const ScaleGap& gap) {
    if (gap != gap_) {
        const QSignalBlocker blocker(this);
        gap_ = gap;
        square_->setChecked(true);
        for (LengthBox* const box : {sizeX_, sizeY_, heightPerValue_}) {
            box->setValue(box->minimum());
        }
    }
    missing_->setText(missingText(gap));
    size_->setVisible(gap.size);
    height_->setVisible(gap.height);
    showState();
}

bool ScaleForm::isComplete() const {
    return (!gap_.size || (sizeX_->isGiven() && sizeY_->isGiven())) &&
           (!gap_.height || heightPerValue_->isGiven());
}

void ScaleForm::showState() {
    const GivenScale now = scale();
    const bool hasPixel = now.sizeX > 0.0 && now.sizeY > 0.0;
    pixel_->setText(hasPixel
                        ? tr("Pixel: %1 × %2")
                              .arg(QString::fromStdString(formatSi(now.sizeX / gap_.columns, "m")),
                                   QString::fromStdString(formatSi(now.sizeY / gap_.rows, "m")))
                        : QString());
    Q_EMIT changed();
}

void ScaleForm::suggest(const GivenScale& scale) {
    const QSignalBlocker unit(square_);
    if (gap_.size && scale.hasSize()) {
        const double pitchX = scale.sizeX / gap_.columns;
        const double pitchY = scale.sizeY / gap_.rows;
        constexpr double kRounding = 1e-9;
        square_->setChecked(std::abs(pitchX - pitchY) <= kRounding * pitchX);
        chooseUnit(*sizeUnit_, scale.sizeX);
        sizeX_->setValue(scale.sizeX / metersOf(*sizeUnit_));
        sizeY_->setValue(scale.sizeY / metersOf(*sizeUnit_));
    }
    if (gap_.height && scale.hasHeight()) {
        chooseUnit(*heightUnit_, scale.heightPerValue);
        heightPerValue_->setValue(scale.heightPerValue / metersOf(*heightUnit_));
    }
    showState();
}

GivenScale ScaleForm::scale() const {
    GivenScale scale;
    if (gap_.size) {
        scale.sizeX = lengthIn(*sizeX_, *sizeUnit_);
        scale.sizeY = lengthIn(*sizeY_, *sizeUnit_);
    }
    if (gap_.height) {
        scale.heightPerValue = lengthIn(*heightPerValue_, *heightUnit_);
    }
    return scale;
}

}  // namespace asperity
