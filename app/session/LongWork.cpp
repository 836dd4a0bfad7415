#include "app/session/LongWork.h"

#include "ui/panels/LoadingBar.h"
#include "ui/window/MainWindow.h"

namespace asperity {

WorkLine loadingLine(MainWindow& window) {
    return {.begin = [&window](const QString& words) { window.showLoading(words); },
            .setFraction = [&window](double share) { window.loading().setFraction(share); },
            .end = [&window] { window.showLoading({}); }};
}

}  // namespace asperity
