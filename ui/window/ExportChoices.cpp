#include "ui/window/ExportChoices.h"

namespace asperity {

bool isPixelFormat(const QString& format) {
    return QStringList{QStringLiteral("png"), QStringLiteral("tif"), QStringLiteral("tiff")}
        .contains(format);
}

bool hasChosenSize(ExportSubject subject, const QString& format) {
    switch (subject) {
    case ExportSubject::View:
    case ExportSubject::Film:
        return true;
    case ExportSubject::Forces:
    case ExportSubject::Cycle:
        return format != QStringLiteral("csv");
    default:
        return false;
    }
}

bool isPicture(ExportSubject subject) { return subject <= ExportSubject::Cycle; }

}  // namespace asperity
