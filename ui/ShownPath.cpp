#include "ui/ShownPath.h"

#include "core/PrintableText.h"

#include <QFile>

namespace asperity {

QString shownPath(const std::filesystem::path& path) {
    return QString::fromStdString(printable(path.string()));
}

std::filesystem::path pathOf(const QString& file) { return QFile::encodeName(file).toStdString(); }

}  // namespace asperity
