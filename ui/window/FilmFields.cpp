#include "ui/window/FilmFields.h"

#include "ui/window/FormParts.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>

namespace asperity {

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
    from_ = newMoments("exportFrom", tr("First moment: choose one, or type seconds of the run"));
    to_ = newMoments("exportTo", tr("Last moment: choose one, or type seconds of the run"));
    partRow_ = newRow({from_, to_});
    form.addRow(tr("From, to"), partRow_);
}

void FilmFields::addLook(QFormLayout& form) {
    view_ = newList("exportFilmView", tr("Where the large view is seen from"));
    for (const ExportOption& view : offer_.filmViews) {
        view_->addItem(view.name, view.key);
    }
    speed_ = named(new QDoubleSpinBox, "exportSpeed",
                   tr("Seconds of the run per second of the film; 0.1: ten times slower"));
    speed_->setRange(0.001, 100.0);
    speed_->setDecimals(3);
    speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    speed_->setPrefix(tr("Speed "));
    speed_->setSuffix(tr(" ×"));
    guardFromWheel(*speed_);
    fps_ = newNumber("exportFps", tr(" frames/s"), 1, 240, tr("Frames a second of the film"));
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
        isBundle
            ? QFileDialog::getOpenFileName(dialog, tr("A bundle of a run"), recording_->text(),
                                           tr("Bundles (*.zip);;All files (*)"))
            : QFileDialog::getExistingDirectory(dialog, tr("Folder of a run"), recording_->text());
    if (!chosen.isEmpty()) {
        recording_->setText(chosen);
    }
}

}  // namespace asperity
