#include "ui/panels/Section.h"

#include "ui/Theme.h"

#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

namespace asperity {

namespace {

constexpr int kSectionGap = 4;              ///< [px]
constexpr int kIndent = 6;                  ///< of the rows [px]
constexpr int kCaptionWidth = 148;          ///< so that the controls of all sections line up [px]
constexpr const char* kWorkingTip = "tip";  ///< property: what a control says while it works

}  // namespace

Section::Section(const QString& title, const QString& about, QWidget* parent)
    : QWidget(parent)
    , about_(about)
    , heading_(new QToolButton(this))
    , content_(new QWidget(this))
    , rows_(new QGridLayout(content_)) {
    heading_->setProperty("heading", true);
    heading_->setObjectName(QStringLiteral("sectionHeading"));
    heading_->setText(title);
    heading_->setFont(theme::boldFont());
    heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    heading_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    rows_->setContentsMargins(kIndent, 0, 0, kSectionGap);
    rows_->setHorizontalSpacing(kSectionGap);
    rows_->setVerticalSpacing(kSectionGap);
    rows_->setColumnStretch(1, 1);
    rows_->setColumnMinimumWidth(0, theme::scaled(kCaptionWidth));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSectionGap);
    column->addWidget(heading_);
    column->addWidget(content_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(heading_, &QToolButton::clicked, this, [this] { setFolded(!folded_); });
    setFolded(false);
}

void Section::setFolded(bool folded) {
    folded_ = folded;
    content_->setVisible(!folded);
    heading_->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    heading_->setToolTip(folded ? tr("%1; click to unfold").arg(about_)
                                : tr("%1; click to fold").arg(about_));
}

void Section::addWide(QWidget* widget) { rows_->addWidget(widget, rows_->rowCount(), 0, 1, 3); }

void Section::refuse(const QString& reason) {
    if (reason == refusal_) {
        return;
    }
    refusal_ = reason;
    content_->setEnabled(reason.isEmpty());
    for (QWidget* part : content_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!part->property(kWorkingTip).isValid()) {
            part->setProperty(kWorkingTip, part->toolTip());
        }
        part->setToolTip(reason.isEmpty() ? part->property(kWorkingTip).toString() : reason);
    }
}

}  // namespace asperity
