#pragma once

#include "app/session/RunControl.h"
#include "core/surface/measure/Profile.h"
#include "ui/measure/LineTool.h"

#include <QLineF>
#include <QObject>

namespace asperity {

class ProfilePage;

/// Samples the surface at rest along the line that is drawn on the whole scan.
class ProfileControl : public QObject {
public:
    ProfileControl(MainWindow& window, RunControl& runs);

    [[nodiscard]] ProfilePage& page() { return *page_; }
    /// Another scan is shown: the line was of the last one.
    void forget();
    /// Samples anew.
    void refresh();

private:
    RunControl& runs_;
    ProfilePage* page_;  ///< the window's
    LineTool line_;
};

/// The mean profile of this many lines side by side, a pixel apart. Where some of them hold no data
/// the others count. @throw Error as profileOf()
[[nodiscard]] Profile meanProfile(const BSplineSurface& surface, const QLineF& line, int width);

}  // namespace asperity
