#include "ui/shell/AboutBox.h"

#include "ui/view/PixelView.h"

#include <vtkOpenGLRenderWindow.h>

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFile>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSysInfo>
#include <QTabWidget>
#include <QThread>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr QSize kAboutSize(720, 520);
constexpr int kListWidth = 240;  ///< of the libraries [px]

QPlainTextEdit* newText(const QString& name, const QString& tip, const QString& text,
                        QWidget* parent) {
    auto* shown = new QPlainTextEdit(text, parent);
    shown->setObjectName(name);
    shown->setToolTip(tip);
    shown->setReadOnly(true);
    return shown;
}

/// The text of a library's license, or where it should be.
QString licenseText(const LibraryFact& library) {
    QFile file(library.licenseFile);
    const QString heading =
        QStringLiteral("%1 %2: %3\n%4\n\n")
            .arg(library.name, library.version, library.license, library.licenseFile);
    return file.open(QIODevice::ReadOnly)
               ? heading + QString::fromUtf8(file.readAll())
               : heading + QObject::tr("This file is not on this machine; the package of the "
                                       "library has it.");
}

QString screenFact(const QScreen& screen) {
    return QObject::tr("Screen %1: %2 × %3 points, %4 pixels a point, %5 dots an inch")
        .arg(screen.name())
        .arg(screen.geometry().width())
        .arg(screen.geometry().height())
        .arg(screen.devicePixelRatio())
        .arg(screen.logicalDotsPerInch(), 0, 'f', 0);
}

/// From what VTK reports: "OpenGL vendor string:  Mesa", a line each.
QString drawingFact(const PixelView& view) {
    if (view.frame().isNull()) {
        return QObject::tr("OpenGL: nothing is drawn yet");
    }
    const QString report = QString::fromUtf8(view.renderWindow().ReportCapabilities());
    const auto text = [&report](const char* name) {
        const QRegularExpression line(QStringLiteral("OpenGL %1 string: *([^\n]*)").arg(name));
        return line.match(report).captured(1);
    };
    return QObject::tr("OpenGL: %1, %2, version %3")
        .arg(text("renderer"), text("vendor"), text("version"));
}

}  // namespace

QString reportText(const ProgramFacts& facts) {
    QStringList lines{QObject::tr("Asperity %1").arg(facts.version),
                      QObject::tr("Compiler: %1").arg(facts.compiler)};
    QStringList libraries;
    for (const LibraryFact& library : facts.libraries) {
        libraries << library.name + QLatin1Char(' ') + library.version;
    }
    lines << QObject::tr("Built with: %1").arg(libraries.join(QStringLiteral(", ")));
    return (lines + facts.system).join(QLatin1Char('\n')) + QLatin1Char('\n');
}

AboutBox::AboutBox(const ProgramFacts& facts, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("About Asperity"));
    setObjectName(QStringLiteral("aboutBox"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* heading = new QLabel(
        tr("<p><b>Asperity %1</b></p>"
           "<p>Touch what an atomic force microscope has scanned: open a height map, move the tip "
           "over it with the mouse or a force-feedback device, and get contact, adhesion and dent "
           "as contact mechanics predicts them. Measure the scan, record the run, and export "
           "pictures, curves and tables.</p>"
           "<p>Free software under the BSD-3-Clause license.</p>")
            .arg(facts.version.toHtmlEscaped()),
        this);
    heading->setObjectName(QStringLiteral("aboutText"));
    heading->setWordWrap(true);
    heading->setTextInteractionFlags(Qt::TextSelectableByMouse);
    heading->setToolTip(tr("What the program does, with its version and license"));
    auto* pages = new QTabWidget(this);
    pages->setObjectName(QStringLiteral("aboutDetails"));
    pages->addTab(versions(facts), tr("&Versions"));
    pages->addTab(licenses(facts), tr("&Licenses"));
    pages->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* const copy =
        buttons->addButton(tr("Copy for a &bug report"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copyReport"));
    copy->setToolTip(tr("Copies versions, system, screens and graphics driver as text"));
    connect(copy, &QPushButton::clicked, this,
            [text = reportText(facts)] { QApplication::clipboard()->setText(text); });
    QPushButton* const details = buttons->addButton(tr("&Details"), QDialogButtonBox::ActionRole);
    details->setObjectName(QStringLiteral("aboutMore"));
    details->setCheckable(true);
    details->setToolTip(tr("Versions and licenses of the program, its libraries and the system"));
    connect(details, &QPushButton::toggled, this, [this, pages](bool shown) {
        pages->setVisible(shown);
        resize(shown ? kAboutSize : QSize(kAboutSize.width(), minimumSizeHint().height()));
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this box"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(heading);
    column->addWidget(pages, 1);
    column->addWidget(buttons);
    resize(kAboutSize.width(), minimumSizeHint().height());
}

QWidget* AboutBox::versions(const ProgramFacts& facts) {
    QStringList lines{tr("Asperity %1").arg(facts.version), facts.compiler, QString()};
    for (const LibraryFact& library : facts.libraries) {
        lines << QStringLiteral("%1 %2 (%3)").arg(library.name, library.version, library.license);
    }
    lines << QString() << facts.system;
    return newText(QStringLiteral("versions"),
                   tr("Versions of the program, its libraries and the system"),
                   lines.join(QLatin1Char('\n')), this);
}

QWidget* AboutBox::licenses(const ProgramFacts& facts) {
    auto* page = new QWidget(this);
    auto* names = new QListWidget(page);
    names->setObjectName(QStringLiteral("licenseNames"));
    names->setToolTip(tr("Asperity and the libraries that it is built with"));
    names->setFixedWidth(kListWidth);
    auto* text = newText(QStringLiteral("licenseText"), tr("The text of the license"), {}, page);
    QStringList texts{facts.license};
    names->addItem(tr("Asperity: BSD-3-Clause"));
    for (const LibraryFact& library : facts.libraries) {
        names->addItem(QStringLiteral("%1: %2").arg(library.name, library.license));
        texts << licenseText(library);
    }
    connect(names, &QListWidget::currentRowChanged, text,
            [text, texts](int row) { text->setPlainText(texts.value(row)); });
    names->setCurrentRow(0);
    auto* row = new QHBoxLayout(page);
    row->addWidget(names);
    row->addWidget(text, 1);
    return page;
}

QStringList systemFacts(const PixelView& view) {
    QStringList facts{
        QObject::tr("System: %1, kernel %2 %3")
            .arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(), QSysInfo::kernelVersion()),
        QObject::tr("Processor: %1, %2 threads")
            .arg(QSysInfo::currentCpuArchitecture())
            .arg(QThread::idealThreadCount()),
        QObject::tr("Qt in use: %1, platform %2, language %3")
            .arg(QString::fromUtf8(qVersion()), QGuiApplication::platformName(),
                 QLocale().bcp47Name())};
    for (const QScreen* const screen : QGuiApplication::screens()) {
        facts << screenFact(*screen);
    }
    return facts << drawingFact(view);
}

}  // namespace asperity
