#include "app/session/LongWork.h"

#include "ui/panels/WorkInBackground.h"
#include "ui/window/MainWindow.h"

namespace asperity {

WorkLine loadingLine(MainWindow& window) {
    WorkInBackground& works = window.works();
    const int place = works.place();
    return {.begin = [&works, place](const QString& words) { works.show(place, words); },
            .setFraction = [&works, place](double share) { works.setFraction(place, share); },
            .end = [] {},
            .enter = [&works,
                      place](const std::function<void()>& cancel) { works.enter(place, cancel); },
            .leave = [&works, place] { works.leave(place); }};
}

}  // namespace asperity
