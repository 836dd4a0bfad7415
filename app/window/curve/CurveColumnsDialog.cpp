#include "app/window/curve/CurveColumnsDialog.h"

#include "core/io/curves/CurveColumns.h"
#include "core/io/curves/ForceCurveFile.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr int kPreviewLines = 40;
constexpr qint64 kLongestLine = 400;
constexpr int kMostSkipped = 1'000'000;
constexpr QSize kColumnsSize(720, 480);  // [px]

/// The first lines with their numbers. A lab's table may be Latin-1: then no byte is refused.
QString previewOf(const std::filesystem::path& path) {
    QFile file(QFile::decodeName(path.c_str()));
    QString text;
    if (file.open(QIODevice::ReadOnly)) {
        for (int line = 1; line <= kPreviewLines && !file.atEnd(); ++line) {
            text += QStringLiteral("%1  %2\n")
                        .arg(line, 3)
                        .arg(QString::fromLatin1(file.readLine(kLongestLine)).trimmed());
        }
    }
    return text;
}

}  // namespace

CurveColumnsDialog::CurveColumnsDialog(std::filesystem::path file, const CurveReadOptions& options,
                                       QWidget* parent)
    : QDialog(parent)
    , file_(std::move(file))
    , options_(options)
    , columns_(named(new TextBox(this), "columnNames",
                     tr("Quantity = number of the column : unit. Quantities: base, separation, "
                        "indentation, deflection, force, signal, time, segment; retract- before "
                        "one: of the retract alone")))
    , skipped_(newNumber("skippedLines", tr(" lines"), 0, kMostSkipped,
                         tr("Lines to skip at the start")))
    , found_(named(new QLabel(this), "columnsFound", tr("Whether the table can be read so"))) {
    setWindowTitle(tr("Columns of %1").arg(shownPath(file_.filename())));
    columns_->setPlaceholderText(QStringLiteral("base=1:um,deflection=2:nm,time=3:ms"));
    skipped_->setValue(options.skippedLines);
    found_->setWordWrap(true);
    auto* const preview = named(new QPlainTextEdit(previewOf(file_)), "tablePreview",
                                tr("First lines of the file, with their numbers"));
    preview->setReadOnly(true);
    preview->setLineWrapMode(QPlainTextEdit::NoWrap);
    preview->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    accept_ = buttons->button(QDialogButtonBox::Open);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(columns_, &QLineEdit::textChanged, this, &CurveColumnsDialog::take);
    connect(skipped_, qOverload<int>(&QSpinBox::valueChanged), this, &CurveColumnsDialog::take);
    auto* const form = new QFormLayout;
    form->addRow(tr("Columns"), columns_);
    form->addRow(tr("Skip"), skipped_);
    auto* const all = new QVBoxLayout(this);
    all->addWidget(preview, 1);
    all->addLayout(form);
    all->addWidget(found_);
    all->addWidget(buttons);
    resize(theme::scaled(kColumnsSize.width()), theme::scaled(kColumnsSize.height()));
    take();
}

void CurveColumnsDialog::take() {
    try {
        const std::string names = columns_->text().trimmed().toStdString();
        CurveReadOptions options{
            .height = options_.height, .columns = {}, .skippedLines = skipped_->value()};
        if (!names.empty()) {
            options.columns = givenColumns(names);
        }
        const ForceCurveFile curves(file_, options);
        std::size_t samples = 0;
        for (const CurveSegment& segment : curves.curve(0).segments) {
            samples += std::max(segment.base.size(), segment.separation.size());
        }
        options_ = options;
        found_->setText(tr("%1 samples can be read").arg(samples));
        accept_->setEnabled(true);
    } catch (const std::exception& error) {
        found_->setText(QString::fromUtf8(error.what()));
        accept_->setEnabled(false);
    }
}

}  // namespace asperity
