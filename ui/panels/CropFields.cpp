#include "ui/panels/CropFields.h"

#include "ui/NumberText.h"
#include "ui/panels/Card.h"
#include "ui/panels/WheelGuard.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <initializer_list>

namespace asperity {

namespace {

constexpr int kCropGap = 6;  // [px]

/// Whether a number is being typed, which does not count yet.
bool isTyped(const QSpinBox& box) {
    return box.hasFocus() && box.findChild<QLineEdit*>()->isModified();
}

}  // namespace

CropFields::CropFields(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kCropGap);
    column_ = addBox(*grid, {0, 0}, "cropColumn", tr("From column"),
                     tr("First column of the part to load [pixel]; 0 is the left one"));
    columns_ =
        addBox(*grid, {1, 0}, "cropColumns", tr("Columns"), tr("How many columns to load [pixel]"));
    row_ = addBox(*grid, {0, 1}, "cropRow", tr("From row"),
                  tr("First row of the part to load [pixel]; 0 is the top one"));
    rows_ = addBox(*grid, {1, 1}, "cropRows", tr("Rows"), tr("How many rows to load [pixel]"));
    extent_ = captionLabel({}, this);
    extent_->setObjectName(QStringLiteral("cropExtent"));
    extent_->setToolTip(tr("Size of the part to load; positions count from its lower left corner"));
    whole_ = new QPushButton(tr("Whole scan"), this);
    whole_->setObjectName(QStringLiteral("cropWhole"));
    whole_->setAutoDefault(false);
    whole_->setToolTip(tr("Load all of the scan"));
    grid->addWidget(extent_, 4, 0);
    grid->addWidget(whole_, 4, 1);
    connect(whole_, &QPushButton::clicked, this, [this] {
        setCrop(std::nullopt);
        Q_EMIT cropEntered(crop_);
    });
    showNumbers(Typed::Goes);
}

QSpinBox* CropFields::addBox(QGridLayout& grid, const QPoint& place, const char* name,
                             const QString& caption, const QString& tip) {
    auto* box = new QSpinBox(this);
    box->setObjectName(QString::fromUtf8(name));
    box->setToolTip(tip);
    box->setKeyboardTracking(false);
    guardFromWheel(*box);
    grid.addWidget(captionLabel(caption, this), 2 * place.y(), place.x());
    grid.addWidget(box, 2 * place.y() + 1, place.x());
    connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &CropFields::enter);
    return box;
}

void CropFields::showScan(const QSize& pixels, const QSizeF& size,
                          const std::optional<PixelRectangle>& crop) {
    pixels_ = pixels.expandedTo({1, 1});
    size_ = size;
    crop_ = crop;
    showNumbers(Typed::Stays);
}

void CropFields::setCrop(const std::optional<PixelRectangle>& crop) {
    crop_ = crop;
    showNumbers(Typed::Goes);
}

/// Another beginning moves the part, and cuts what would lie beyond the scan.
void CropFields::enter() {
    const int column = std::min(column_->value(), pixels_.width() - 1);
    const int row = std::min(row_->value(), pixels_.height() - 1);
    const PixelRectangle part{column, row, std::min(columns_->value(), pixels_.width() - column),
                              std::min(rows_->value(), pixels_.height() - row)};
    const bool isAll = part == PixelRectangle{0, 0, pixels_.width(), pixels_.height()};
    setCrop(isAll ? std::nullopt : std::optional(part));
    Q_EMIT cropEntered(crop_);
}

void CropFields::showNumbers(Typed typed) {
    const PixelRectangle part =
        crop_.value_or(PixelRectangle{0, 0, pixels_.width(), pixels_.height()});
    const auto put = [typed](QSpinBox& box, int least, int most, int value) {
        if (typed == Typed::Stays && isTyped(box)) {
            return;
        }
        const QSignalBlocker blocker(box);
        box.setRange(least, most);
        box.setValue(value);
    };
    put(*column_, 0, pixels_.width() - 1, part.column);
    put(*row_, 0, pixels_.height() - 1, part.row);
    put(*columns_, 1, pixels_.width(), part.columns);
    put(*rows_, 1, pixels_.height(), part.rows);
    whole_->setEnabled(crop_.has_value());
    extent_->setText(
        size_.isEmpty()
            ? QString()
            : tr("%1 × %2").arg(siText(size_.width() * part.columns / pixels_.width(), "m"),
                                siText(size_.height() * part.rows / pixels_.height(), "m")));
}

}  // namespace asperity
