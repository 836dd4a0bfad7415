#include "app/session/SessionFolder.h"

#include "app/runs/RunFolder.h"
#include "app/session/WindowSection.h"

#include <QStandardPaths>

#include <fcntl.h>
#include <string>
#include <system_error>

namespace asperity {

namespace {

constexpr const char* kSession = "session.toml";
constexpr const char* kBefore = "session_before.toml";
constexpr const char* kLast = "session_last.toml";
const QString kEdited = QStringLiteral("session/edited");

/// Names for sessions that cannot be opened, from 1.
std::filesystem::path unopened(const std::filesystem::path& folder, int number) {
    const std::string end = number == 1 ? ".toml" : "_" + std::to_string(number) + ".toml";
    return folder / ("session_unopened" + end);
}

int firstFree(const std::filesystem::path& folder) {
    int number = 1;
    while (isThere(unopened(folder, number))) {
        ++number;
    }
    return number;
}

}  // namespace

SessionFolder::SessionFolder(const std::filesystem::path& folder) : folder_(folder), lock_(-1) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    lock_ = FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    isOurs_ = lock_.isOpen() && lock_.lock();
    if (isOurs_) {
        passOn();
    }
}

void SessionFolder::passOn() {
    std::error_code failure;
    if (isThere(session())) {
        if (isEditedIn(windowSectionOf(session()))) {
            std::filesystem::rename(session(), folder_ / kBefore, failure);
            std::filesystem::remove(folder_ / kLast, failure);
        } else {
            std::filesystem::rename(session(), folder_ / kLast, failure);
        }
    }
    for (const char* const name : {kLast, kBefore}) {
        if (last_.empty() && isThere(folder_ / name)) {
            last_ = folder_ / name;
        }
    }
}

std::filesystem::path SessionFolder::session() const { return folder_ / kSession; }

std::filesystem::path SessionFolder::before() const {
    if (!isOurs_) {
        return {};
    }
    if (isThere(folder_ / kBefore)) {
        return folder_ / kBefore;
    }
    const int next = firstFree(folder_);
    return next > 1 ? unopened(folder_, next - 1) : last_;
}

bool SessionFolder::holds(const std::filesystem::path& file) const {
    return file.parent_path() == folder_;
}

std::filesystem::path SessionFolder::setLastAside() {
    const std::filesystem::path aside = unopened(folder_, firstFree(folder_));
    std::error_code failure;
    std::filesystem::rename(last_, aside, failure);
    std::filesystem::path where = failure ? last_ : aside;
    last_.clear();
    return where;
}

void keepEdited(bool isEdited, QVariantMap& kept) { kept.insert(kEdited, isEdited); }

/// Sessions of programs that noted nothing may have been edited.
bool isEditedIn(const QVariantMap& kept) {
    return !kept.isEmpty() && kept.value(kEdited, true).toBool();
}

std::filesystem::path sessionFolder() {
    const QString place = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return std::filesystem::path(place.toStdString()) / "session";
}

}  // namespace asperity
