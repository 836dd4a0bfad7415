#include "app/window/live/ControlBar.h"

#include "core/scene/SettingFields.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/FlowLayout.h"
#include "ui/widgets/LabStyle.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

namespace asperity {

namespace {

constexpr int kControlHeight = 26;         ///< [px, as theme::scaled() takes them]
constexpr int kKnobWidth = 96;             ///< same
constexpr int kKnobLetterRoom = 8;         ///< [px]
constexpr int kMaxGroupWidth = 260;        ///< of a list with what belongs to it [px]
constexpr const char* kUsableTip = "tip";  ///< property: what a control says while it can be used

void addWithCaption(FlowLayout& bar, const QString& caption, const QList<QWidget*>& widgets,
                    int stretch) {
    auto* group = new QWidget(bar.parentWidget());
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(1);
    column->addWidget(captionLabel(caption, group));
    group->setToolTip(widgets.front()->toolTip());
    auto* row = new QHBoxLayout;
    row->setSpacing(3);
    for (QWidget* widget : widgets) {
        row->addWidget(widget);
    }
    column->addLayout(row);
    group->setMaximumWidth(theme::scaled(kMaxGroupWidth));
    bar.addWidget(group, stretch);
}

void addSeparator(FlowLayout& bar) {
    auto* line = new QFrame(bar.parentWidget());
    line->setFrameShape(QFrame::VLine);
    line->setFixedHeight(theme::scaled(kControlHeight));
    line->setFrameShadow(QFrame::Plain);
    theme::follow(line, [line] {
        QPalette palette = line->palette();
        palette.setColor(QPalette::WindowText, theme::colors().faint);
        line->setPalette(palette);
    });
    bar.addWidget(line);
}

void setQuietly(GainSpinBox& box, double value) {
    const QSignalBlocker blocker(box);
    box.setValue(value);
}

}  // namespace

ControlBar::ControlBar(QWidget* parent) : QWidget(parent), row_(new FlowLayout(this)) {
    row_->setContentsMargins(8, 4, 8, 4);
    row_->setSpacing(8);
    startPause_ = addButton("startPause", tr("Pause"));
    startPause_->setToolTip(tr("Start or pause the run"));
    startPause_->setProperty("primary", true);
    startPause_->setFont(theme::boldFont());
    forces_ = addButton("forces", tr("Forces are off"));
    forces_->setCheckable(true);
    forces_->setToolTip(tr("Switch the forces on the device on or off"));
    addSeparator(*row_);
    material_ = addCombo("material", tr("Material"));
    material_->setToolTip(tr("Sample material; another one restarts the run at this position"));
    device_ = addCombo("device", tr("Device"));
    device_->setToolTip(tr("What moves the base of the cantilever"));
    path_ = addCombo("path", tr("Path"));
    path_->setToolTip(tr("What the device Scripted path does"));
    addKnobs();
    setKnobs({});
    row_->addStretch();
    record_ = addButton("record", tr("Recording"));
    record_->setCheckable(true);
    record_->setToolTip(tr("Write every tick to a log"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setRunning(false);
    setForcesOn(true);
    setRecording(false);
    connectInputs();
    theme::follow(this, [this] {
        setRunning(startPause_->property("running").toBool());
        setForcesOn(forces_->isChecked());
        setRecording(record_->isChecked());
    });
}

QPushButton* ControlBar::addButton(const char* objectName, const QString& widest) {
    auto* button = new QPushButton(controlIcon(ControlIcon::Start), widest, this);
    button->setObjectName(QString::fromUtf8(objectName));
    button->ensurePolished();
    // Letters are wider than measured where a pixel of the window is 1.5 of the screen.
    button->setFixedSize(button->sizeHint().width() + kKnobLetterRoom,
                         theme::scaled(kControlHeight));
    row_->addWidget(button);
    return button;
}

ChoiceBox* ControlBar::addCombo(const char* objectName, const QString& caption) {
    auto* combo = new ChoiceBox(this);
    combo->setObjectName(QString::fromUtf8(objectName));
    combo->setFixedHeight(theme::scaled(kControlHeight));
    guardFromWheel(*combo);
    QList<QWidget*> widgets{combo};
    if (combo->objectName() == QStringLiteral("path")) {
        pathFile_ = new QToolButton(this);
        pathFile_->setObjectName(QStringLiteral("pathFile"));
        pathFile_->setText(QStringLiteral("…"));
        pathFile_->setToolTip(tr("Follow a path from a file"));
        pathFile_->setFixedHeight(theme::scaled(kControlHeight));
        widgets << pathFile_;
    }
    addWithCaption(*row_, caption, widgets, 1);
    return combo;
}

void ControlBar::addKnobs() {
    std::map<int, SettingField> shown;
    const Settings any;
    listSettings(any, [&shown](const SettingField& field, const auto& /*value*/) {
        if (field.knob.slot > 0) {
            shown.emplace(field.knob.slot, field);
        }
    });
    for (const auto& [slot, field] : shown) {
        addKnob(field);
    }
}

void ControlBar::addKnob(const SettingField& field) {
    auto* box = new GainSpinBox(field.knob.low, field.knob.high, this);
    box->setObjectName(QString::fromUtf8(field.knob.name));
    box->setToolTip(coreWords(field.words.toolTip));
    box->setFixedSize(theme::scaled(kKnobWidth), theme::scaled(kControlHeight));
    guardFromWheel(*box);
    addWithCaption(*row_, coreWords(field.words.caption), {box}, 0);
    knobs_[field.column] = box;
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this, name = QString::fromUtf8(field.column)](double value) {
                Q_EMIT knobTurned(name, value);
            });
}

void ControlBar::connectInputs() {
    connect(startPause_, &QPushButton::clicked, this, [this] {
        const bool running = !startPause_->property("running").toBool();
        setRunning(running);
        Q_EMIT runningChosen(running);
    });
    connect(forces_, &QPushButton::clicked, this, [this](bool on) {
        setForcesOn(on);
        Q_EMIT forcesChosen(on);
    });
    connect(record_, &QPushButton::clicked, this, [this](bool recording) {
        setRecording(recording);
        Q_EMIT recordingChosen(recording);
    });
    // activated() and clicked() come from people only.
    connect(material_, qOverload<int>(&QComboBox::activated), this, &ControlBar::materialChosen);
    connect(device_, qOverload<int>(&QComboBox::activated), this, &ControlBar::deviceChosen);
    connect(path_, qOverload<int>(&QComboBox::activated), this, &ControlBar::pathChosen);
    connect(pathFile_, &QToolButton::clicked, this, &ControlBar::pathFileRequested);
}

void ControlBar::setMaterials(const QStringList& names) { material_->setNames(names); }

void ControlBar::setDevices(const QStringList& names) { device_->setNames(names); }

void ControlBar::setPaths(const QStringList& names) { path_->setNames(names); }

void ControlBar::setMaterial(int index) { material_->setCurrentIndex(index); }

void ControlBar::setDevice(int index) { device_->setCurrentIndex(index); }

void ControlBar::setPath(int index) { path_->setCurrentIndex(index); }

void ControlBar::setRunning(bool running) {
    startPause_->setProperty("running", running);
    startPause_->setText(running ? tr("Pause") : tr("Start"));
    startPause_->setIcon(controlIcon(running ? ControlIcon::Pause : ControlIcon::Start));
}

void ControlBar::setForcesOn(bool on) {
    forces_->setChecked(on);
    forces_->setIcon(controlIcon(on ? ControlIcon::ForcesOn : ControlIcon::ForcesOff));
    forces_->setText(on ? tr("Forces are on") : tr("Forces are off"));
}

bool ControlBar::forcesOn() const { return forces_->isChecked(); }

void ControlBar::setKnobs(const Settings& settings) {
    listSettings(settings, [this](const SettingField& field, const auto& value) {
        if (const auto knob = knobs_.find(field.column); knob != knobs_.end()) {
            setQuietly(*knob->second, static_cast<double>(value));
        }
    });
}

void ControlBar::refuse(QWidget& control, const QString& reason) {
    if (!control.property(kUsableTip).isValid()) {
        control.setProperty(kUsableTip, control.toolTip());
    }
    control.setEnabled(reason.isEmpty());
    control.setToolTip(reason.isEmpty() ? control.property(kUsableTip).toString() : reason);
}

void ControlBar::refuseKnob(const std::string& column, const QString& reason) {
    knobRefusals_[column] = reason;
    showRefusals();
}

void ControlBar::refuseTip(const QString& reason) {
    tipRefusal_ = reason;
    showRefusals();
}

void ControlBar::fix(const QString& reason) {
    fixedBy_ = reason;
    showRefusals();
}

void ControlBar::showRefusals() {
    for (QWidget* const widget : std::initializer_list<QWidget*>{device_, path_, pathFile_}) {
        refuse(*widget, fixedBy_.isEmpty() ? tipRefusal_ : fixedBy_);
    }
    for (const auto& [column, box] : knobs_) {
        const auto own = knobRefusals_.find(column);
        refuse(*box, fixedBy_.isEmpty() && own != knobRefusals_.end() ? own->second : fixedBy_);
    }
    for (QWidget* const widget : std::initializer_list<QWidget*>{startPause_, material_, record_}) {
        refuse(*widget, fixedBy_);
    }
}

void ControlBar::setRecording(bool recording) {
    record_->setChecked(recording);
    record_->setIcon(controlIcon(ControlIcon::Record));
    record_->setText(recording ? tr("Recording") : tr("Record"));
}

}  // namespace asperity
