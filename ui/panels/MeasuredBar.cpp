#include "ui/panels/MeasuredBar.h"

#include "ui/Theme.h"
#include "ui/panels/NumberBox.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace asperity {

namespace {

constexpr double kMaxOffset = 1e6;     ///< [nm]
constexpr int kMeasuredBoxWidth = 92;  ///< [px]

}  // namespace

MeasuredBar::MeasuredBar(QWidget* parent)
    : QWidget(parent), name_(new QLabel(this)), offset_(new NumberBox(this)) {
    setToolTip(tr("A measured curve that is drawn over the cycles"));
    name_->setObjectName(QStringLiteral("measuredName"));
    name_->setMinimumWidth(1);
    offset_->setObjectName(QStringLiteral("measuredOffset"));
    offset_->setRange(-kMaxOffset, kMaxOffset);
    offset_->setSuffix(tr(" nm"));
    offset_->setSingleStep(0.1);
    offset_->setFixedWidth(kMeasuredBoxWidth);
    offset_->setToolTip(tr("Moves the measured curve along the distance axis [nm]; at 0 its "
                           "contact, where its approach last passes zero force, is at 0"));
    auto* remove = new QToolButton(this);
    remove->setObjectName(QStringLiteral("removeMeasured"));
    remove->setText(tr("Remove"));
    remove->setToolTip(tr("Takes the measured curve out of the plot"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(name_, 1);
    row->addWidget(offset_);
    row->addWidget(remove);
    for (QWidget* const widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(offset_),
                                  static_cast<QWidget*>(remove)}) {
        widget->setFont(theme::textFont(theme::kSmallSize));
    }
    remove->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    connect(offset_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &MeasuredBar::offsetChanged);
    connect(remove, &QToolButton::clicked, this, &MeasuredBar::removeChosen);
    hide();
}

void MeasuredBar::setCurve(const QString& name, const QString& details) {
    whole_ = name;
    name_->setToolTip(details);
    const QSignalBlocker silent(offset_);
    offset_->setValue(0.0);
    setVisible(!name.isEmpty());
    showName();
}

double MeasuredBar::offset() const { return 1e-9 * offset_->value(); }

void MeasuredBar::showName() {
    const QString text = tr("measured: %1").arg(whole_);
    name_->setText(name_->fontMetrics().elidedText(text, Qt::ElideMiddle, name_->width()));
}

void MeasuredBar::resizeEvent(QResizeEvent* /*event*/) { showName(); }

}  // namespace asperity
