#include "ui/window/RecentMenu.h"

#include <QAction>
#include <QMenu>

namespace asperity {

RecentMenu::RecentMenu(QMenu& menu) : QObject(&menu), menu_(menu.addMenu(tr("Open r&ecent"))) {
    menu_->setObjectName(QStringLiteral("recent"));
    menu_->setToolTipsVisible(true);
    connect(menu_, &QMenu::aboutToShow, this, &RecentMenu::aboutToShow);
    setFiles({});
}

void RecentMenu::setFiles(const std::vector<RecentFile>& files) {
    menu_->clear();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const RecentFile& file = files[i];
        const QString name = QString(file.name).replace('&', QStringLiteral("&&"));
        const QString number = i < 9 ? QStringLiteral("&%1").arg(i + 1) : QStringLiteral("1&0");
        QAction* entry = menu_->addAction(QStringLiteral("%1  %2").arg(number, name));
        entry->setEnabled(file.isThere);
        entry->setToolTip(file.isThere ? tr("Open %1").arg(file.path)
                                       : tr("%1 is not there any more").arg(file.path));
        connect(entry, &QAction::triggered, this,
                [this, index = static_cast<int>(i)] { Q_EMIT chosen(index); });
    }
    menu_->addSeparator();
    QAction* clear = menu_->addAction(tr("&Clear list"));
    clear->setToolTip(tr("Forget the files that were opened last"));
    // Later: the entry itself goes.
    connect(clear, &QAction::triggered, this, &RecentMenu::clearRequested, Qt::QueuedConnection);
    menu_->menuAction()->setEnabled(!files.empty());
    menu_->menuAction()->setToolTip(files.empty() ? tr("No file was opened yet")
                                                  : tr("Files that were opened last"));
}

}  // namespace asperity
