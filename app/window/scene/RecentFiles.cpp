#include "app/window/scene/RecentFiles.h"

#include "core/PrintableText.h"

#include <QAction>
#include <QMenu>

#include <algorithm>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

const QString kFiles = QStringLiteral("open/recentFiles");
const QString kFolder = QStringLiteral("open/folder");

}  // namespace

void RecentFiles::remember(std::unique_ptr<QSettings> settings) {
    settings_ = std::move(settings);
    files_.clear();
    for (const QString& text : settings_->value(kFiles).toStringList()) {
        const auto file = pathFromText(text.toStdString());
        if (file && !file->empty() && files_.size() < kMax) {
            files_.push_back(*file);
        }
    }
    folder_ = settings_->value(kFolder).toString();
    Q_EMIT changed();
}

void RecentFiles::leaveOut(const std::filesystem::path& folder) {
    leftOut_ = folder;
    const auto isInside = [&folder](const std::filesystem::path& file) {
        return file.parent_path() == folder;
    };
    if (std::erase_if(files_, isInside) > 0) {
        write();
        Q_EMIT changed();
    }
}

void RecentFiles::add(const std::filesystem::path& file) {
    std::error_code unknown;
    const std::filesystem::path whole = std::filesystem::absolute(file, unknown).lexically_normal();
    if (unknown || whole.parent_path() == leftOut_) {
        return;
    }
    std::erase(files_, whole);
    files_.insert(files_.begin(), whole);
    files_.resize(std::min<std::size_t>(files_.size(), kMax));
    write();
    Q_EMIT changed();
}

void RecentFiles::clear() {
    files_.clear();
    write();
    Q_EMIT changed();
}

void RecentFiles::setFolder(const QString& folder) {
    folder_ = folder;
    write();
}

void RecentFiles::write() {
    if (!settings_) {
        return;
    }
    QStringList texts;
    for (const std::filesystem::path& file : files_) {
        texts << QString::fromStdString(pathText(file));
    }
    settings_->setValue(kFiles, texts);
    settings_->setValue(kFolder, folder_);
}

RecentMenu::RecentMenu(QMenu& menu) : QObject(&menu), menu_(menu) {
    connect(&menu_, &QMenu::aboutToShow, this, &RecentMenu::aboutToShow);
    setFiles({});
}

void RecentMenu::setFiles(const std::vector<RecentFile>& files) {
    menu_.clear();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const RecentFile& file = files[i];
        const QString name = QString(file.name).replace('&', QStringLiteral("&&"));
        const QString number = i < 9 ? QStringLiteral("&%1").arg(i + 1) : QStringLiteral("1&0");
        QAction* entry = menu_.addAction(QStringLiteral("%1  %2").arg(number, name));
        entry->setEnabled(file.isThere);
        entry->setToolTip(file.isThere ? tr("Open %1").arg(file.path)
                                       : tr("%1 is not there any more").arg(file.path));
        connect(entry, &QAction::triggered, this,
                [this, index = static_cast<int>(i)] { Q_EMIT chosen(index); });
    }
    menu_.addSeparator();
    QAction* clear = menu_.addAction(tr("&Clear list"));
    clear->setToolTip(tr("Forget the files that were opened last"));
    // Later: the entry itself goes.
    connect(clear, &QAction::triggered, this, &RecentMenu::clearRequested, Qt::QueuedConnection);
    menu_.menuAction()->setEnabled(!files.empty());
    menu_.menuAction()->setToolTip(files.empty() ? tr("No file was opened yet")
                                                 : tr("Files that were opened last"));
}

}  // namespace asperity
