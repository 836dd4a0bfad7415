#include "app/session/UserFolder.h"

#include <QStandardPaths>

namespace asperity {

std::filesystem::path userFolder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return std::filesystem::path(documents.toStdString()) / "Asperity";
}

}  // namespace asperity
