#include "app/window/export/ExportDialog.h"

#include "ui/shell/Dialogs.h"
#include "ui/shell/FileDialogs.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/Theme.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QScreen>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr int kExportGap = 8;        // [px]
constexpr int kChoicesWidth = 430;   // [px, as theme::scaled() takes them]
constexpr int kExportWidth = 1060;   // [px, scaled]
constexpr int kExportHeight = 600;   // [px, scaled]
constexpr int kMinPictureSide = 32;  // [pixel]
constexpr int kMaxSide = 8192;       // [pixel]
constexpr int kScreenDpi = 96;
constexpr int kPrintDpi = 300;
constexpr double kMillimetersPerInch = 25.4;

QString nameOfFormat(const QString& format) {
    if (format == QStringLiteral("frames")) {
        return ExportDialog::tr("Folder of pictures (PNG)");
    }
    return format.toUpper();
}

constexpr int kCheck = 8;      // [px]
constexpr int kWordEdge = 24;  // [px]

/// Light whatever the theme, as the page that a picture goes to.
void paintChecks(QPainter& painter, const QRect& area) {
    const QColor light = toQColor(kLightPalette.paper);
    painter.fillRect(area, light);
    painter.save();
    painter.setClipRect(area);
    for (int y = 0; y * kCheck < area.height(); ++y) {
        for (int x = y % 2; x * kCheck < area.width(); x += 2) {
            painter.fillRect(area.left() + x * kCheck, area.top() + y * kCheck, kCheck, kCheck,
                             light.darker(112));
        }
    }
    painter.restore();
}

}  // namespace

FilmFields::FilmFields(QFormLayout& form, const ExportOffer& offer)
    : QObject(form.parentWidget()), offer_(offer) {
    addRecording(form);
    addPart(form);
    addLook(form);
    connectInputs();
}

void FilmFields::addRecording(QFormLayout& form) {
    recording_ = named(new QLineEdit, "exportRecording",
                       tr("Folder of a run or a recording, or a bundle (.zip)"));
    auto* folder = newButton(tr("Folder…"), "exportRecordingFolder", tr("Choose a folder"));
    auto* bundle = newButton(tr("Bundle…"), "exportRecordingBundle", tr("Choose a bundle"));
    recordingRow_ = newRow({recording_, folder, bundle});
    form.addRow(tr("&Recording"), recordingRow_);
    connect(folder, &QPushButton::clicked, this, [this] { browse(false); });
    connect(bundle, &QPushButton::clicked, this, [this] { browse(true); });
}

void FilmFields::addPart(QFormLayout& form) {
    from_ =
        newMoments("exportFrom", tr("First moment: choose one, or type seconds from the start"));
    to_ = newMoments("exportTo", tr("Last moment: choose one, or type seconds from the start"));
    partRow_ = newRow({from_, to_});
    form.addRow(tr("From, to"), partRow_);
}

void FilmFields::addLook(QFormLayout& form) {
    view_ = newList("exportFilmView", tr("Where the large view is seen from"));
    for (const ExportOption& view : offer_.filmViews) {
        view_->addItem(view.name, view.key);
    }
    speed_ = named(new GainSpinBox(0.001, 100.0), "exportSpeed",
                   tr("Seconds of the run per second of the film; 0.1: ten times slower"));
    speed_->setSuffix(tr(" × speed"));
    guardFromWheel(*speed_);
    fps_ = newNumber("exportFps", tr(" frames/s"), 1, 240, tr("Frame rate of the film"));
    form.addRow(tr("Vie&w"), view_);
    rateRow_ = newRow({speed_, fps_});
    form.addRow(tr("Film"), rateRow_);
}

QComboBox* FilmFields::newMoments(const char* name, const QString& tip) const {
    QComboBox* const list = newList(name, tip);
    list->setEditable(true);
    list->setInsertPolicy(QComboBox::NoInsert);
    list->lineEdit()->setToolTip(tip);
    for (const ExportOption& moment : offer_.moments) {
        list->addItem(moment.name, moment.key);
    }
    return list;
}

void FilmFields::connectInputs() {
    connect(recording_, &QLineEdit::textChanged, this, &FilmFields::changed);
    for (const QComboBox* const list : {from_, to_}) {
        connect(list, &QComboBox::editTextChanged, this, &FilmFields::changed);
    }
    connect(view_, qOverload<int>(&QComboBox::currentIndexChanged), this, &FilmFields::changed);
    connect(speed_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &FilmFields::changed);
    connect(fps_, qOverload<int>(&QSpinBox::valueChanged), this, &FilmFields::changed);
}

void FilmFields::show(const FilmChoices& choices) {
    const QSignalBlocker quiet(this);
    recording_->setText(choices.recording);
    showMoment(*from_, choices.from);
    showMoment(*to_, choices.to);
    view_->setCurrentIndex(std::max(0, view_->findData(choices.view)));
    speed_->setValue(choices.speed);
    fps_->setValue(choices.fps);
}

FilmChoices FilmFields::choices() const {
    return {.recording = recording_->text(),
            .view = view_->currentData().toString(),
            .from = momentOf(*from_),
            .to = momentOf(*to_),
            .speed = speed_->value(),
            .fps = fps_->value()};
}

void FilmFields::setEnabled(bool enabled) {
    for (QWidget* const row :
         std::initializer_list<QWidget*>{recordingRow_, partRow_, view_, rateRow_}) {
        row->setEnabled(enabled);
    }
}

/// Its name where it has one, else as it is: a time in seconds.
void FilmFields::showMoment(QComboBox& list, const QString& key) const {
    const int index = list.findData(key);
    if (index >= 0) {
        list.setCurrentIndex(index);
    } else {
        list.setEditText(key);
    }
}

/// The key of a name, or what was typed without its unit.
QString FilmFields::momentOf(const QComboBox& list) const {
    QString text = list.currentText().trimmed();
    for (const ExportOption& moment : offer_.moments) {
        if (text.compare(moment.name, Qt::CaseInsensitive) == 0) {
            return moment.key;
        }
    }
    if (text.endsWith(QStringLiteral("s")) && !text.isEmpty() && text.at(0).isDigit()) {
        text.chop(1);
    }
    return text.trimmed();
}

void FilmFields::browse(bool isBundle) {
    QWidget* const dialog = recordingRow_->window();
    const QString chosen =
        isBundle ? askWhatToOpen(dialog, {.kind = FileKind::Bundle,
                                          .title = tr("A bundle of a run"),
                                          .suggestion = recording_->text(),
                                          .filters = tr("Bundles (*.zip);;All files (*)")})
                 : askWhichFolder(dialog, {.kind = FileKind::Recording,
                                           .title = tr("Folder of a run"),
                                           .suggestion = recording_->text()});
    if (!chosen.isEmpty()) {
        recording_->setText(chosen);
    }
}

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
    setGeometry(openingGeometry(ExportDialog::sizeHint(), screen()->availableGeometry()));
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
    addLocation(*form);
    return side;
}

void ExportDialog::addPicture(QFormLayout& form) {
    column_ = newList("exportColumn", tr("A width in pixels, or that of a journal's column"));
    width_ = newNumber("exportWidth", tr(" px"), kMinPictureSide, kMaxSide, tr("Width in pixels"));
    height_ =
        newNumber("exportHeight", tr(" px"), kMinPictureSide, kMaxSide, tr("Height in pixels"));
    dpi_ = newNumber("exportDpi", tr(" dpi"), 24, 2400,
                     tr("Dots per inch: text and lines grow with it"));
    form.addRow(tr("W&idth"), column_);
    form.addRow(tr("&Size"), newRow({width_, height_, dpi_}));
}

void ExportDialog::addParts(QFormLayout& form) {
    transparent_ = named(new QCheckBox(tr("&Transparent background")), "exportTransparent",
                         tr("Without a background color"));
    bars_ = named(new QCheckBox(tr("Scale bars, color &bars and axes")), "exportBars",
                  tr("Show the scales of lengths, heights and colors"));
    labels_ = named(new QCheckBox(tr("Tit&les, notes and values")), "exportLabels",
                    tr("Write names and values into the picture"));
    clean_ = named(new QCheckBox(tr("Clea&n: none of them, and no grid")), "exportClean",
                   tr("Draw only surface and tip; in a plot, only curves and axes"));
    dent_ = named(new QCheckBox(tr("&Displacement colors a contact")), "exportDent",
                  tr("Show dent and neck by their colors; off: the large view as the window colors "
                     "it, a film by height"));
    form.addRow(tr("Parts"), transparent_);
    for (QCheckBox* const box : {bars_, labels_, clean_, dent_}) {
        form.addRow(QString(), box);
    }
}

void ExportDialog::addLocation(QFormLayout& form) {
    folder_ = named(new QLineEdit, "exportFolder", tr("Folder of the file"));
    auto* browse = newButton(tr("…"), "exportBrowse", tr("Choose a folder"));
    browse->setAccessibleName(tr("Choose a folder"));
    name_ = named(new QLineEdit, "exportName",
                  tr("Name without its extension; {file}: name of the scan or of the "
                     "recording, {view}: what is written, {n}: first number that is free"));
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
    dent_->setChecked(choices_.dent);
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
    for (const QCheckBox* const box : {transparent_, bars_, labels_, clean_, dent_}) {
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
        const double most = kMaxSide / std::max(inches, inches / aspect);
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
    choices_.dent = dent_->isChecked();
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
    dent_->setEnabled(isFilm || choices_.subject == ExportSubject::View);
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
    const QString folder = askWhichFolder(this, {.kind = FileKind::ExportFolder,
                                                 .title = tr("Folder of the file"),
                                                 .suggestion = folder_->text()});
    if (!folder.isEmpty()) {
        folder_->setText(folder);
    }
}

ExportPicture::ExportPicture(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("exportPreview"));
    setToolTip(tr("The picture as it will be, smaller"));
    setMinimumSize(theme::scaled(280), theme::scaled(210));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ExportPicture::setPicture(const QImage& picture) {
    picture_ = picture;
    words_.clear();
    update();
}

void ExportPicture::setWords(const QString& words) {
    picture_ = {};
    words_ = words;
    update();
}

void ExportPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setPen(theme::colors().muted);
    if (picture_.isNull()) {
        painter.drawText(rect().adjusted(kWordEdge, 0, -kWordEdge, 0),
                         Qt::AlignCenter | Qt::TextWordWrap, words_);
        return;
    }
    QRect area(QPoint(), picture_.size().scaled(size(), Qt::KeepAspectRatio));
    area.moveCenter(rect().center());
    if (picture_.hasAlphaChannel()) {
        paintChecks(painter, area);
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, picture_);
    painter.drawRect(area.adjusted(0, 0, -1, -1));
}

}  // namespace asperity
