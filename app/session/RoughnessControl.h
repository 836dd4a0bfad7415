#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"
#include "ui/measure/RectangleTool.h"
#include "ui/measure/RoughnessPage.h"

namespace asperity {

/// Computes the roughness of the scan, or of the rectangle that is drawn on it, in the background,
/// while somebody looks at it.
class RoughnessControl : public QObject {
public:
    RoughnessControl(MainWindow& window, RunControl& runs);

    [[nodiscard]] RoughnessPage& page() { return *page_; }
    /// Another scan is shown: the rectangle was of the last one.
    void forget();
    /// The surface is another one, or there is none.
    void refresh();

private:
    struct Result {
        RoughnessPage::Subject subject;
        Roughness roughness;
    };

    /// @param rectangle empty: all of the scan
    [[nodiscard]] static Result compute(const Scene& scene, const QRectF& rectangle,
                                        Progress& progress);

    RunControl& runs_;
    RoughnessPage* page_;  ///< the window's
    RectangleTool rectangle_;
    bool due_ = true;  ///< what the page shows is of another surface or rectangle
    BackgroundWork<Result> work_;
};

}  // namespace asperity
