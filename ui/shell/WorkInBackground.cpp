#include "ui/shell/WorkInBackground.h"

#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>
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
    cancel->setFocusPolicy(Qt::NoFocus);  // it comes and goes; the keys keep moving the device
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

void WorkInBackground::enter(int ticket, const std::function<void()>& cancel) {
    Work work{.ticket = ticket, .cancel = cancel, .words = {}, .fraction = 0.0};
    if (const Work* const before = at(ticket)) {
        work.words = before->words;
        std::erase_if(works_, [ticket](const Work& one) { return one.ticket == ticket; });
    }
    works_.push_back(work);
}

void WorkInBackground::show(int ticket, const QString& words) {
    if (Work* const work = at(ticket)) {
        work->words = words;
        tell();
    }
}

void WorkInBackground::setFraction(int ticket, double fraction) {
    if (Work* const work = at(ticket)) {
        work->fraction = fraction;
        if (work == latestShown()) {
            Q_EMIT progressed(fraction);
        }
    }
}

void WorkInBackground::leave(int ticket) {
    const Work* const work = at(ticket);
    const bool wasNamed = work != nullptr && work == latestShown();
    std::erase_if(works_, [ticket](const Work& one) { return one.ticket == ticket; });
    if (wasNamed) {
        tell();
    }
}

void WorkInBackground::cancel() {
    const Work* const named = latestShown();
    if (named != nullptr || !works_.empty()) {
        const std::function<void()> end = named != nullptr ? named->cancel : works_.back().cancel;
        end();
    }
}

WorkInBackground::Work* WorkInBackground::at(int ticket) {
    const auto found = std::ranges::find(works_, ticket, &Work::ticket);
    return found == works_.end() ? nullptr : &*found;
}

WorkInBackground::Work* WorkInBackground::latestShown() {
    const auto found = std::find_if(works_.rbegin(), works_.rend(),
                                    [](const Work& work) { return !work.words.isEmpty(); });
    return found == works_.rend() ? nullptr : &*found;
}

void WorkInBackground::tell() {
    const Work* const work = latestShown();
    Q_EMIT named(work == nullptr ? QString() : work->words);
    if (work != nullptr) {
        Q_EMIT progressed(work->fraction);
    }
}

}  // namespace asperity
