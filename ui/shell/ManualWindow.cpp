#include "ui/shell/ManualWindow.h"

#include "ui/widgets/Theme.h"

#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kManualWidth = 760;   // [px, as theme::scaled() takes them]
constexpr int kManualHeight = 640;  // same
const QString kPageSuffix = QStringLiteral("md");

}  // namespace

ManualWindow::ManualWindow(const std::filesystem::path& folder, QWidget* parent)
    : QWidget(parent, Qt::Tool)
    , folder_(QFile::decodeName(folder.c_str()))
    , page_(new QTextBrowser(this)) {
    setWindowTitle(tr("Manual"));
    setObjectName(QStringLiteral("manualWindow"));
    page_->setObjectName(QStringLiteral("manualPage"));
    page_->setAccessibleName(tr("Page of the manual"));
    page_->setToolTip(tr("A page of the manual; a click on a link opens another"));
    page_->setOpenLinks(false);
    auto* back = new QPushButton(tr("Back"), this);
    back->setObjectName(QStringLiteral("manualBack"));
    back->setToolTip(tr("The page before"));
    back->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->addWidget(back);
    row->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(page_, 1);
    connect(back, &QPushButton::clicked, page_, &QTextBrowser::backward);
    connect(page_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    connect(page_, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
    resize(theme::scaled(kManualWidth), theme::scaled(kManualHeight));
}

bool ManualWindow::open(const QString& page) {
    const QFileInfo file(folder_ + QLatin1Char('/') + page);
    if (!file.isFile()) {
        Q_EMIT missing(tr("%1 is not there: the manual is not installed with this program")
                           .arg(file.filePath()));
        return false;
    }
    page_->setSource(QUrl::fromLocalFile(file.absoluteFilePath()));
    return true;
}

QString ManualWindow::text() const { return page_->toPlainText(); }

/// Pages are shown here, anything else by the desktop.
void ManualWindow::follow(const QUrl& link) {
    const QUrl target = page_->source().resolved(link);
    if (!target.isLocalFile()) {
        QDesktopServices::openUrl(target);
        return;
    }
    const QFileInfo file(target.toLocalFile());
    if (!file.exists()) {
        Q_EMIT missing(
            tr("%1 is not there: it is not part of the installed manual").arg(file.filePath()));
    } else if (file.suffix() == kPageSuffix) {
        page_->setSource(target);
    } else {
        QDesktopServices::openUrl(target);
    }
}

}  // namespace asperity
