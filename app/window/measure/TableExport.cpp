#include "app/window/measure/TableExport.h"

#include "core/Error.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Host.h"

#include <QFile>
#include <QFileInfo>

namespace asperity {

void askForTable(Host& host, const QString& title, const QString& name, const WriteTable& write) {
    QString file = askWhereToSave(&host.widget(), {.kind = FileKind::Table,
                                                   .title = title,
                                                   .suggestion = name,
                                                   .filters = QObject::tr("Tables (*.csv)")});
    if (!file.isEmpty()) {
        file += QFileInfo(file).suffix().isEmpty() ? QStringLiteral(".csv") : QString();
        writeTableTo(host, QFile::encodeName(file).toStdString(), write);
    }
}

void writeTableTo(Host& host, const std::filesystem::path& file, const WriteTable& write) {
    try {
        write(file);
        host.tell(QObject::tr("Saved as %1").arg(QString::fromStdString(file.string())));
    } catch (const Error& error) {
        host.complain(QString::fromUtf8(error.what()));
    }
}

}  // namespace asperity
