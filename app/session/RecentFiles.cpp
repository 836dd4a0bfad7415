#include "app/session/RecentFiles.h"

#include "core/PathText.h"

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
        if (file && !file->empty() && files_.size() < kMost) {
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
    files_.resize(std::min<std::size_t>(files_.size(), kMost));
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

}  // namespace asperity
