#include "ui/window/ViewSide.h"

#include "ui/panels/EngageBar.h"
#include "ui/panels/LoadingBar.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ZoomView.h"
#include "ui/window/SecondView.h"
#include "ui/window/Splitters.h"
#include "ui/window/ViewBars.h"

#include <QLabel>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kHalf = 1000;  // of the width, for each view once both are shown

}  // namespace

ViewSide::ViewSide(const Parts& parts, QWidget* parent)
    : QWidget(parent)
    , parts_(parts)
    , column_(new QVBoxLayout(this))
    , views_(newSplitter(Qt::Horizontal, "views", this))
    , bars_(new ViewBars(*parts.view, this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kPanelGap);
    column_->addWidget(parts.banner);
    column_->addWidget(parts.engage);
    views_->addWidget(parts.view);
    views_->addWidget(parts.second);
    views_->setStretchFactor(0, 1);
    views_->setStretchFactor(1, 1);
    views_->setSizes({kHalf, kHalf});
    parts.second->hide();
    column_->addWidget(views_, 1);
    column_->addWidget(bars_);
    addBottomLine();
}

/// Hint and loading in one place, so that nothing moves when a file is loaded.
void ViewSide::addBottomLine() {
    auto* hint = new QLabel(this);
    hint->setObjectName(QStringLiteral("hint"));
    hint->setAlignment(Qt::AlignCenter);
    hint->setToolTip(tr("What the mouse does in the large view; keys: Help > Mouse and keys"));
    parts_.view->setAccessibleDescription(
        tr("The sample around the tip, the tip and the force on it, in three dimensions"));
    bottomLine_ = new QStackedLayout;
    bottomLine_->addWidget(hint);
    bottomLine_->addWidget(parts_.loading);
    column_->addLayout(bottomLine_);
}

void ViewSide::setHint(const QString& hint) {
    static_cast<QLabel*>(bottomLine_->widget(0))->setText(hint);
}

void ViewSide::setLoading(bool loading) { bottomLine_->setCurrentIndex(loading ? 1 : 0); }

}  // namespace asperity
