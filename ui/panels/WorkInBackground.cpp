#include "ui/panels/WorkInBackground.h"

#include <algorithm>

namespace asperity {

void WorkInBackground::enter(int place, const std::function<void()>& cancel) {
    Work work{.place = place, .cancel = cancel, .words = {}, .fraction = 0.0};
    if (const Work* const before = at(place)) {
        work.words = before->words;
        std::erase_if(works_, [place](const Work& one) { return one.place == place; });
    }
    works_.push_back(work);
}

void WorkInBackground::show(int place, const QString& words) {
    if (Work* const work = at(place)) {
        work->words = words;
        tell();
    }
}

void WorkInBackground::setFraction(int place, double fraction) {
    if (Work* const work = at(place)) {
        work->fraction = fraction;
        if (work == latestShown()) {
            Q_EMIT progressed(fraction);
        }
    }
}

void WorkInBackground::leave(int place) {
    const Work* const work = at(place);
    const bool wasNamed = work != nullptr && work == latestShown();
    std::erase_if(works_, [place](const Work& one) { return one.place == place; });
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

WorkInBackground::Work* WorkInBackground::at(int place) {
    const auto found = std::ranges::find(works_, place, &Work::place);
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
