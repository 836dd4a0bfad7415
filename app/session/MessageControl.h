#pragma once

#include "app/session/RunControl.h"

namespace asperity {

/// Lists in the window's messages what nobody is shown in a box: faults when they come and go, and
/// what was noted about a scan while it was loaded.
class MessageControl : public QObject {
    Q_OBJECT

public:
    /// @param window, runs outlive this
    MessageControl(MainWindow& window, RunControl& runs);

    /// Once a frame. There is a run.
    void advance();

private:
    void listNotes();
    void list(const std::vector<std::string>& notes, std::vector<std::string>& listed);

    MainWindow& window_;
    RunControl& runs_;
    Fault fault_ = Fault::None;             ///< listed last
    std::vector<std::string> heightNotes_;  ///< listed last
    std::vector<std::string> forceNotes_;   ///< listed last
};

}  // namespace asperity
