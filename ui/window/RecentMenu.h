#pragma once

#include "ui/window/OpenPreview.h"

#include <QObject>

#include <vector>

class QMenu;

namespace asperity {

/// The files that were opened last as a submenu, with an entry that forgets them.
class RecentMenu : public QObject {
    Q_OBJECT

public:
    /// @param menu gets it at its end
    explicit RecentMenu(QMenu& menu);

    /// The newest first. One that is not there any more is disabled, and its tool tip says so.
    void setFiles(const std::vector<RecentFile>& files);

Q_SIGNALS:
    void aboutToShow();
    /// @param index of the files
    void chosen(int index);
    void clearRequested();

private:
    QMenu* menu_;
};

}  // namespace asperity
