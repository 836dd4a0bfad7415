#include "ui/panels/LoadingBar.h"

#include "ui/Theme.h"
#include "ui/panels/Card.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

namespace asperity {

namespace {

constexpr int kLoadingBarHeight = 14;  ///< [px]
constexpr int kWhole = 100;            ///< of the bar [%]
constexpr int kWordsWidth = 320;       ///< at most: a file's name may be long [px]

}  // namespace

LoadingBar::LoadingBar(QWidget* parent)
    : QWidget(parent), words_(captionLabel(QString(), this)), bar_(new QProgressBar(this)) {
    words_->setObjectName(QStringLiteral("loadingWords"));
    words_->setTextFormat(Qt::PlainText);
    bar_->setObjectName(QStringLiteral("loadingBar"));
    setToolTip(tr("How much of the file is read and checked"));
    bar_->setRange(0, kWhole);
    bar_->setFixedHeight(theme::scaled(kLoadingBarHeight));
    bar_->setFont(theme::textFont(theme::kSmallSize));
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName(QStringLiteral("cancelLoading"));
    cancel->setFocusPolicy(Qt::NoFocus);  // it comes and goes; the keys lead the device meanwhile
    cancel->setToolTip(tr("Stop this; the scene stays as it is"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 0, 10, 0);
    layout->setSpacing(12);
    layout->addWidget(words_);
    layout->addWidget(bar_, 1);
    layout->addWidget(cancel);
    connect(cancel, &QPushButton::clicked, this, &LoadingBar::cancelRequested);
}

void LoadingBar::begin(const QString& words) {
    words_->setToolTip(words);
    words_->setText(
        words_->fontMetrics().elidedText(words, Qt::ElideMiddle, theme::scaled(kWordsWidth)));
    setFraction(0.0);
}

void LoadingBar::setFraction(double fraction) {
    bar_->setValue(static_cast<int>(std::floor(kWhole * fraction)));
}

}  // namespace asperity
