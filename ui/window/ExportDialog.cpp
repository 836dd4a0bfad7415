#include "ui/window/ExportDialog.h"

#include "ui/Theme.h"
#include "ui/window/ExportPicture.h"
#include "ui/window/FilmFields.h"
#include "ui/window/FormParts.h"
#include "ui/window/Placement.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr int kExportGap = 8;       // [px]
constexpr int kChoicesWidth = 430;  // [px, as theme::scaled() takes them]
constexpr int kExportWidth = 1060;  // likewise
constexpr int kExportHeight = 600;  // likewise
constexpr int kLeastSide = 32;      // [pixel]
constexpr int kMostSide = 8192;     // [pixel]
constexpr int kScreenDpi = 96;
constexpr int kPrintDpi = 300;
constexpr double kMillimetersPerInch = 25.4;

QString nameOfFormat(const QString& format) {
    if (format == QStringLiteral("frames")) {
        return ExportDialog::tr("Folder of pictures (PNG)");
    }
    return format.toUpper();
}

}  // namespace

ExportDialog::ExportDialog(ExportOffer offer, ExportChoices choices, QWidget* window)
    : QDialog(window), offer_(std::move(offer)), choices_(std::move(choices)) {
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    auto* sides = new QHBoxLayout;
    sides->setSpacing(2 * kExportGap);
    sides->addWidget(newForm());
    sides->addWidget(newPreview(), 1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(2 * kExportGap, 2 * kExportGap, 2 * kExportGap, 2 * kExportGap);
    rows->setSpacing(kExportGap);
    rows->addLayout(sides, 1);
    rows->addWidget(newButtons());
    fill();
    connectInputs();
    setGeometry(openingPlace(ExportDialog::sizeHint(), screen()->availableGeometry()));
    subject_->setFocus();
}

QSize ExportDialog::sizeHint() const {
    return {theme::scaled(kExportWidth), theme::scaled(kExportHeight)};
}

QWidget* ExportDialog::newForm() {
    auto* side = new QWidget(this);
    side->setFixedWidth(theme::scaled(kChoicesWidth));
    auto* form = new QFormLayout(side);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(kExportGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    subject_ = newList("exportSubject", tr("What is written"));
    format_ = newList("exportFormat", tr("Type of the file"));
    form->addRow(tr("&What"), subject_);
    form->addRow(tr("&Format"), format_);
    addPicture(*form);
    addParts(*form);
    film_ = new FilmFields(*form, offer_);
    addPlace(*form);
    return side;
}

void ExportDialog::addPicture(QFormLayout& form) {
    column_ = newList("exportColumn", tr("A width in pixels, or that of a journal's column"));
    width_ = newNumber("exportWidth", tr(" px"), kLeastSide, kMostSide, tr("Width in pixels"));
    height_ = newNumber("exportHeight", tr(" px"), kLeastSide, kMostSide, tr("Height in pixels"));
    dpi_ = newNumber("exportDpi", tr(" dpi"), 24, 2400,
                     tr("Dots an inch: letters and lines grow with it"));
    form.addRow(tr("W&idth"), column_);
    form.addRow(tr("&Size"), newRow({width_, height_, dpi_}));
}

void ExportDialog::addParts(QFormLayout& form) {
    transparent_ = named(new QCheckBox(tr("&Transparent background")), "exportTransparent",
                         tr("Nothing is behind what is drawn"));
    bars_ = named(new QCheckBox(tr("Scale bars, color &bars and axes")), "exportBars",
                  tr("Draw what lengths, heights and colors are measured by"));
    labels_ = named(new QCheckBox(tr("Tit&les, notes and values")), "exportLabels",
                    tr("Write names and values into the picture"));
    clean_ = named(new QCheckBox(tr("Clea&n: none of them, and no grid")), "exportClean",
                   tr("Draw the surface and the tip alone; of a plot, the curves and axes"));
    form.addRow(tr("Parts"), transparent_);
    for (QCheckBox* const box : {bars_, labels_, clean_}) {
        form.addRow(QString(), box);
    }
}

void ExportDialog::addPlace(QFormLayout& form) {
    folder_ = named(new QLineEdit, "exportFolder", tr("Folder that the file goes to"));
    auto* browse = newButton(tr("…"), "exportBrowse", tr("Choose a folder"));
    browse->setAccessibleName(tr("Choose a folder"));
    name_ = named(new QLineEdit, "exportName",
                  tr("Name without its extension; {file}: name of the scan, {view}: what is "
                     "written, {n}: first number that is free"));
    file_ = named(new QLabel, "exportFile", tr("The file that will be written"));
    file_->setTextFormat(Qt::PlainText);
    file_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    theme::colorText(*file_, &ThemeColors::muted);
    form.addRow(tr("F&older"), newRow({folder_, browse}));
    form.addRow(tr("N&ame"), name_);
    form.addRow(QString(), file_);
    connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
}

QWidget* ExportDialog::newPreview() {
    picture_ = new ExportPicture(this);
    return picture_;
}

QDialogButtonBox* ExportDialog::newButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Cancel)->setIcon({});  // no other button has one
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Write nothing"));
    copy_ = newButton(tr("&Copy"), "exportCopy",
                      tr("Put the picture on the clipboard instead of into a file"));
    export_ = named(new QPushButton(tr("&Export")), "exportWrite", tr("Write the file"));
    export_->setDefault(true);
    buttons->addButton(copy_, QDialogButtonBox::ActionRole);
    buttons->addButton(export_, QDialogButtonBox::AcceptRole);
    message_ = named(new QLabel(buttons), "exportMessage", tr("Why nothing can be written"));
    message_->setTextFormat(Qt::PlainText);
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    theme::colorText(*message_, &ThemeColors::fault);
    static_cast<QBoxLayout*>(buttons->layout())->insertWidget(0, message_, 1);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(copy_, &QPushButton::clicked, this, &ExportDialog::copyRequested);
    connect(export_, &QPushButton::clicked, this, &ExportDialog::exportRequested);
    return buttons;
}

/// The choices as they were kept.
void ExportDialog::fill() {
    for (const auto& row : kEnumTable<ExportSubject>) {
        subject_->addItem(tr(row.name), static_cast<int>(row.value));
    }
    subject_->setCurrentIndex(static_cast<int>(choices_.subject));
    column_->addItem(tr("Pixels"), QString());
    for (const ExportColumn& column : offer_.columns) {
        column_->addItem(tr("Column %1 (%2 mm)").arg(column.name).arg(column.width), column.name);
    }
    column_->setCurrentIndex(std::max(0, column_->findData(choices_.column)));
    width_->setValue(choices_.size.width());
    height_->setValue(choices_.size.height());
    dpi_->setValue(choices_.dpi);
    transparent_->setChecked(choices_.transparent);
    bars_->setChecked(choices_.bars);
    labels_->setChecked(choices_.labels);
    clean_->setChecked(choices_.clean);
    film_->show(choices_.film);
    folder_->setText(choices_.folder);
    name_->setText(choices_.name);
    showFormats();
    showState();
}

void ExportDialog::connectInputs() {
    connect(subject_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
        choices_.subject = static_cast<ExportSubject>(index);
        showFormats();
        take();
    });
    connect(format_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportDialog::take);
    connect(column_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        const QSignalBlocker quiet(dpi_);
        dpi_->setValue(column_->currentIndex() == 0 ? kScreenDpi : kPrintDpi);
        chooseSize();
    });
    connect(dpi_, qOverload<int>(&QSpinBox::valueChanged), this, &ExportDialog::chooseSize);
    for (QSpinBox* const box : {width_, height_}) {
        connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &ExportDialog::take);
    }
    connect(film_, &FilmFields::changed, this, &ExportDialog::take);
    for (const QCheckBox* const box : {transparent_, bars_, labels_, clean_}) {
        connect(box, &QCheckBox::toggled, this, &ExportDialog::take);
    }
    for (const QLineEdit* const line : {folder_, name_}) {
        connect(line, &QLineEdit::textChanged, this, &ExportDialog::take);
    }
}

QString ExportDialog::format() const { return format_->currentData().toString(); }

/// Each subject keeps the format that was chosen for it last.
void ExportDialog::showFormats() {
    const QSignalBlocker quiet(format_);
    format_->clear();
    for (const OfferedFormat& format : offer_.formats.at(choices_.subject)) {
        format_->addItem(nameOfFormat(format.key), format.key);
    }
    const auto kept = choices_.formats.find(choices_.subject);
    const int index = kept == choices_.formats.end() ? 0 : format_->findData(kept->second);
    format_->setCurrentIndex(std::max(0, index));
}

/// A column and its dots an inch say how many pixels the width has; the shape stays.
void ExportDialog::chooseSize() {
    const int index = column_->currentIndex() - 1;
    if (index >= 0) {
        const double aspect = static_cast<double>(width_->value()) / height_->value();
        const double inches =
            offer_.columns[static_cast<std::size_t>(index)].width / kMillimetersPerInch;
        const QSignalBlocker quietDpi(dpi_);
        const QSignalBlocker quietWidth(width_);
        const QSignalBlocker quietHeight(height_);
        // The picture stays as wide as the column: no more dots than the longer side can have.
        const double most = kMostSide / std::max(inches, inches / aspect);
        dpi_->setValue(std::min(dpi_->value(), static_cast<int>(most)));
        width_->setValue(static_cast<int>(std::lround(inches * dpi_->value())));
        height_->setValue(static_cast<int>(std::lround(width_->value() / aspect)));
    }
    take();
}

void ExportDialog::take() {
    choices_.formats[choices_.subject] = format();
    choices_.column = column_->currentData().toString();
    choices_.size = {width_->value(), height_->value()};
    choices_.dpi = dpi_->value();
    choices_.transparent = transparent_->isChecked();
    choices_.bars = bars_->isChecked();
    choices_.labels = labels_->isChecked();
    choices_.clean = clean_->isChecked();
    choices_.film = film_->choices();
    choices_.folder = folder_->text();
    choices_.name = name_->text();
    showState();
    Q_EMIT changed();
}

/// What has no effect on the file cannot be chosen.
void ExportDialog::showState() {
    const bool isFilm = choices_.subject == ExportSubject::Film;
    const auto index = static_cast<std::size_t>(format_->currentIndex());
    const bool isSized = offer_.formats.at(choices_.subject).at(index).isSized;
    const bool isVideo = isFilm && format() != QStringLiteral("frames");
    film_->setEnabled(isFilm);
    for (QWidget* const part : std::initializer_list<QWidget*>{column_, height_, dpi_, clean_}) {
        part->setEnabled(isSized);
    }
    width_->setEnabled(isSized && column_->currentIndex() == 0);
    transparent_->setEnabled(isSized && !isVideo);
    bars_->setEnabled(isSized && !clean_->isChecked());
    labels_->setEnabled(isSized && !clean_->isChecked());
    copy_->setEnabled(isPicture(choices_.subject));
}

void ExportDialog::showPreview(const QImage& picture) { picture_->setPicture(picture); }

void ExportDialog::showWords(const QString& words) { picture_->setWords(words); }

void ExportDialog::showFile(const QString& path) {
    file_->setText(file_->fontMetrics().elidedText(path, Qt::ElideMiddle, file_->width()));
    file_->setToolTip(path.isEmpty() ? tr("The file that will be written") : path.toHtmlEscaped());
}

void ExportDialog::showFailure(const QString& reason) {
    message_->setText(reason);
    export_->setEnabled(reason.isEmpty());
    copy_->setEnabled(reason.isEmpty() && isPicture(choices_.subject));
}

QSize ExportDialog::previewRoom() const { return picture_->size(); }

void ExportDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    Q_EMIT changed();
}

void ExportDialog::browse() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Folder of the file"), folder_->text());
    if (!folder.isEmpty()) {
        folder_->setText(folder);
    }
}

}  // namespace asperity
