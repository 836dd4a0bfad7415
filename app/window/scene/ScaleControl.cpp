#include "app/window/scene/ScaleControl.h"

#include "core/SiFormat.h"
#include "core/surface/GivenScale.h"
#include "ui/shell/Host.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr int kDialogGap = 8;    // [px]
constexpr int kTextWidth = 400;  // [px]
constexpr int kNameWidth = 260;  // [px]

/// A name of a file or channel, which may be long and look like markup.
QString shortened(const QString& name, const QWidget& label) {
    return label.fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth);
}

QLabel* nameLabel(const QString& file, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::boldFont());
    label->setText(shortened(file, *label));
    label->setToolTip(file.toHtmlEscaped());
    return label;
}

QLabel* channelLabel(const ScaleGap& gap, QWidget* parent) {
    QLabel* label = captionLabel({}, parent);
    label->setText(ScaleDialog::tr("Channel “%1”, %2 × %3 pixels")
                       .arg(shortened(QString::fromStdString(gap.channel), *label))
                       .arg(gap.columns)
                       .arg(gap.rows));
    return label;
}

ScaleControl::Kind kindOf(const std::filesystem::path& file, const ScaleGap& gap) {
    return {file.extension().string(), gap.columns, gap.rows};
}

}  // namespace

ScaleDialog::ScaleDialog(const QString& file, const ScaleGap& gap, QWidget* window)
    : QDialog(window), form_(new ScaleForm(Qt::Vertical, this)) {
    setWindowTitle(tr("Scale of the scan"));
    setObjectName(QStringLiteral("scaleDialog"));
    form_->setMinimumWidth(theme::scaled(kTextWidth));
    form_->setGap(gap);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kDialogGap, 2 * kDialogGap, 2 * kDialogGap, 2 * kDialogGap);
    column->setSpacing(kDialogGap);
    column->addWidget(nameLabel(file, this));
    column->addWidget(channelLabel(gap, this));
    column->addWidget(form_);
    column->addWidget(newButtons());
}

QDialogButtonBox* ScaleDialog::newButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    for (QAbstractButton* const button : buttons->buttons()) {
        button->setIcon({});  // no other button has one
    }
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    ok->setToolTip(tr("Open the scan with this scale"));
    ok->setEnabled(form_->isComplete());
    connect(form_, &ScaleForm::changed, ok, [this, ok] { ok->setEnabled(form_->isComplete()); });
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Open nothing"));
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        accept();
        Q_EMIT given(scale());
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void ScaleDialog::suggest(const GivenScale& scale) { form_->suggest(scale); }

GivenScale ScaleDialog::scale() const { return form_->scale(); }

void ScaleControl::ask(const std::filesystem::path& file, const ScaleGap& gap) {
    withdraw();
    const QString name = shownPath(file.filename());
    dialog_ = new ScaleDialog(name, gap, &host_.widget());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto known = suggestion(file, gap)) {
        dialog_->suggest(*known);
    }
    connect(dialog_, &ScaleDialog::given, this, [this, file, gap](const GivenScale& scale) {
        learn(file, gap, scale);
        Q_EMIT given(scale);
    });
    connect(dialog_, &QDialog::rejected, this, &ScaleControl::refused);
    dialog_->open();
}

std::optional<GivenScale> ScaleControl::suggestion(const std::filesystem::path& file,
                                                   const ScaleGap& gap) const {
    const auto known = known_.find(kindOf(file, gap));
    return known == known_.end() ? std::nullopt : std::optional(known->second);
}

void ScaleControl::learn(const std::filesystem::path& file, const ScaleGap& gap,
                         const GivenScale& scale) {
    GivenScale& known = known_[kindOf(file, gap)];
    known = merged(known, scale);
}

void ScaleControl::withdraw() {
    if (dialog_ != nullptr) {
        disconnect(dialog_, nullptr, this, nullptr);
        dialog_->close();
    }
}

namespace {

constexpr int kScaleGap = 8;        // [px]
constexpr int kScaleBoxWidth = 90;  // [px]

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
    box->setMinimumWidth(theme::scaled(kScaleBoxWidth));
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
    grid->setSpacing(kScaleGap);
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
    , heightPerValue_(
          newLengthBox("heightPerValue", tr("Height of a value of 1 in the file"), height_))
    , heightUnit_(newUnitBox(kHeightUnits, "nm", height_))
    , pixel_(captionLabel({}, size_)) {
    missing_->setTextFormat(Qt::PlainText);
    missing_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kScaleGap);
    column->addWidget(missing_);
    addSize(*newFields(*size_));
    addHeight(*newFields(*height_));
    auto* fields = new QBoxLayout(orientation == Qt::Vertical ? QBoxLayout::TopToBottom
                                                              : QBoxLayout::LeftToRight);
    fields->setSpacing(kScaleGap);
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
    pixel_->setText(hasPixel ? tr("Pixel: %1 × %2")
                                   .arg(siText(now.sizeX / gap_.columns, "m"),
                                        siText(now.sizeY / gap_.rows, "m"))
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
