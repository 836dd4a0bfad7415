#include "ui/window/ScaleDialog.h"

#include "core/SiFormat.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/LengthBox.h"
#include "ui/panels/RefusalLine.h"
#include "ui/panels/WheelGuard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <array>
#include <cmath>
#include <initializer_list>

namespace asperity {

namespace {

constexpr int kGap = 8;          // [px]
constexpr int kBoxWidth = 150;   // [px]
constexpr int kTextWidth = 400;  // [px]
constexpr int kNameWidth = 260;  // [px]
constexpr int kColumns = 3;      // caption, number, unit

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
    if (gap.size && gap.height) {
        return ScaleDialog::tr("The file holds neither the size of the scan nor the unit of its "
                               "values.");
    }
    return gap.size ? ScaleDialog::tr("The file does not hold the size of the scan.")
                    : ScaleDialog::tr("The file does not hold the unit of its values.");
}

/// A name of a file or channel, which may be long and look like markup.
QString shortened(const QString& name, const QWidget& label) {
    return label.fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth);
}

QLabel* newText(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setMinimumWidth(theme::scaled(kTextWidth));
    return label;
}

QLabel* nameLabel(const QString& file, QWidget* parent) {
    QLabel* label = newText({}, parent);
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

}  // namespace

ScaleDialog::ScaleDialog(const QString& file, const ScaleGap& gap, QWidget* window)
    : QDialog(window)
    , gap_(gap)
    , sizeX_(new LengthBox(this))
    , sizeY_(new LengthBox(this))
    , sizeUnit_(newUnitBox(kSizeUnits, "µm", this))
    , square_(new QCheckBox(tr("Square pixels"), this))
    , height_(new LengthBox(this))
    , heightUnit_(newUnitBox(kHeightUnits, "nm", this))
    , pixel_(captionLabel({}, this))
    , ok_(nullptr) {
    setWindowTitle(tr("Scale of the scan"));
    setObjectName(QStringLiteral("scaleDialog"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(2 * kGap, 2 * kGap, 2 * kGap, 2 * kGap);
    grid->setSpacing(kGap);
    grid->addWidget(nameLabel(file, this), 0, 0, 1, kColumns);
    grid->addWidget(newText(missingText(gap), this), 1, 0, 1, kColumns);
    grid->addWidget(channelLabel(gap, this), 2, 0, 1, kColumns);
    addSize(*grid);
    addHeight(*grid);
    addButtons(*grid);
    connectInputs();
    showState();
}

void ScaleDialog::addSize(QGridLayout& grid) {
    sizeX_->setObjectName(QStringLiteral("sizeX"));
    sizeY_->setObjectName(QStringLiteral("sizeY"));
    sizeUnit_->setObjectName(QStringLiteral("sizeUnit"));
    square_->setObjectName(QStringLiteral("squarePixels"));
    pixel_->setObjectName(QStringLiteral("pixelSize"));
    square_->setChecked(true);
    sizeX_->setToolTip(tr("Length of the whole scan along x, the fast axis"));
    sizeY_->setToolTip(tr("Length of the whole scan along y, the slow axis"));
    sizeUnit_->setToolTip(tr("Unit of both lengths"));
    pixel_->setToolTip(tr("Distance of neighboring pixels along x and y"));
    square_->setToolTip(tr("One side follows from the other by the numbers of pixels"));
    QLabel* x = captionLabel(tr("Scan size along x"), this);
    QLabel* y = captionLabel(tr("Scan size along y"), this);
    const int row = grid.rowCount();
    grid.addWidget(x, row, 0);
    grid.addWidget(sizeX_, row, 1);
    grid.addWidget(sizeUnit_, row, 2);
    grid.addWidget(y, row + 1, 0);
    grid.addWidget(sizeY_, row + 1, 1);
    grid.addWidget(square_, row + 1, 2);
    grid.addWidget(pixel_, row + 2, 1, 1, 2);
    for (QWidget* const part :
         std::initializer_list<QWidget*>{x, y, sizeX_, sizeY_, sizeUnit_, square_, pixel_}) {
        part->setVisible(gap_.size);
    }
}

void ScaleDialog::addHeight(QGridLayout& grid) {
    height_->setObjectName(QStringLiteral("heightPerValue"));
    heightUnit_->setObjectName(QStringLiteral("heightUnit"));
    height_->setToolTip(tr("Height that one unit of the file's values stands for"));
    heightUnit_->setToolTip(tr("Unit of this height"));
    QLabel* caption = captionLabel(tr("A value of 1 is a height of"), this);
    const int row = grid.rowCount();
    grid.addWidget(caption, row, 0);
    grid.addWidget(height_, row, 1);
    grid.addWidget(heightUnit_, row, 2);
    for (QWidget* const part : std::initializer_list<QWidget*>{caption, height_, heightUnit_}) {
        part->setVisible(gap_.height);
    }
}

void ScaleDialog::addButtons(QGridLayout& grid) {
    for (LengthBox* const box : {sizeX_, sizeY_, height_}) {
        box->setMinimumWidth(theme::scaled(kBoxWidth));
        guardFromWheel(*box);
    }
    const int row = grid.rowCount();
    grid.addWidget(new RefusalLine(this), row, 0, 1, kColumns);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    grid.addWidget(buttons, row + 1, 0, 1, kColumns);
    grid.setColumnStretch(1, 1);
    for (QAbstractButton* const button : buttons->buttons()) {
        button->setIcon({});  // no other button has one
    }
    ok_ = buttons->button(QDialogButtonBox::Ok);
    ok_->setToolTip(tr("Open the scan with this scale"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Open nothing"));
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        accept();
        Q_EMIT given(scale());
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ScaleDialog::connectInputs() {
    for (LengthBox* const box : {sizeX_, sizeY_, height_}) {
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, box] {
            follow(*box);
            showState();
        });
        connect(box->findChild<QLineEdit*>(), &QLineEdit::textChanged, this,
                &ScaleDialog::showState);
        connect(box, &NumberBox::refused, this, &ScaleDialog::showState);
    }
    connect(square_, &QCheckBox::toggled, this, [this] {
        follow(sizeX_->isBlank() ? *sizeY_ : *sizeX_);
        showState();
    });
    connect(sizeUnit_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &ScaleDialog::showState);
}

void ScaleDialog::follow(const LengthBox& entered) {
    if (!square_->isChecked() || &entered == height_ || entered.isBlank()) {
        return;
    }
    const bool isX = &entered == sizeX_;
    const double aspect = static_cast<double>(gap_.rows) / gap_.columns;
    LengthBox& other = isX ? *sizeY_ : *sizeX_;
    const QSignalBlocker blocker(other);
    other.setValue(entered.value() * (isX ? aspect : 1.0 / aspect));
}

bool ScaleDialog::isComplete() const {
    return (!gap_.size || (sizeX_->isGiven() && sizeY_->isGiven())) &&
           (!gap_.height || height_->isGiven());
}

void ScaleDialog::showState() {
    ok_->setEnabled(isComplete());
    const GivenScale now = scale();
    const bool hasPixel = now.sizeX > 0.0 && now.sizeY > 0.0;
    pixel_->setText(hasPixel
                        ? tr("Pixel: %1 × %2")
                              .arg(QString::fromStdString(formatSi(now.sizeX / gap_.columns, "m")),
                                   QString::fromStdString(formatSi(now.sizeY / gap_.rows, "m")))
                        : QString());
}

void ScaleDialog::suggest(const GivenScale& scale) {
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
        height_->setValue(scale.heightPerValue / metersOf(*heightUnit_));
    }
    showState();
}

GivenScale ScaleDialog::scale() const {
    GivenScale scale;
    if (gap_.size) {
        scale.sizeX = lengthIn(*sizeX_, *sizeUnit_);
        scale.sizeY = lengthIn(*sizeY_, *sizeUnit_);
    }
    if (gap_.height) {
        scale.heightPerValue = lengthIn(*height_, *heightUnit_);
    }
    return scale;
}

}  // namespace asperity
