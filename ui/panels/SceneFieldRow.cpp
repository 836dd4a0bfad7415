#include "ui/panels/SceneFieldRow.h"

#include "core/scene/SceneFieldChange.h"
#include "ui/CoreWords.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/ChoiceBox.h"
#include "ui/panels/GainSpinBox.h"
#include "ui/panels/LevelingEditor.h"
#include "ui/panels/TextBox.h"
#include "ui/panels/WheelGuard.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVariant>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kFieldWidth = 96;  ///< of a number, at least [px]
constexpr int kResetWidth = 22;  ///< [px]
constexpr int kFieldDecimals = 12;

QString captionOf(const SceneField& field) {
    const QString caption = coreWords(field.words.caption);
    return *field.words.unit == '\0'
               ? caption
               : QStringLiteral("%1 [%2]").arg(caption, QString::fromUtf8(field.words.unit));
}

/// Steps by factors where there is no zero.
NumberBox* newBox(const SceneField& field, QWidget* parent) {
    const double low = field.limits.low / field.words.scale;
    const double high = field.limits.high / field.words.scale;
    if (field.input == SceneInput::Number && low > 0.0) {
        return new GainSpinBox(low, high, parent);
    }
    auto* box = new NumberBox(parent);
    box->setDecimals(field.input == SceneInput::Whole ? 0 : kFieldDecimals);
    box->setRange(low, high);
    if (field.input == SceneInput::Number) {
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    }
    return box;
}

}  // namespace

SceneFieldRow::SceneFieldRow(const SceneField& field, QGridLayout& grid, QWidget* parent)
    : QObject(parent)
    , field_(field)
    , choices_(field.choices)
    , caption_(captionLabel(captionOf(field), parent))
    , control_(newControl(parent))
    , reset_(new QToolButton(parent)) {
    const QString name = QString::fromStdString(nameOf(field));
    control_->setObjectName(name);
    reset_->setObjectName(name + QStringLiteral(".reset"));
    reset_->setText(QStringLiteral("↺"));
    reset_->setProperty("heading", true);  // the sign alone, without a frame
    reset_->setFixedWidth(theme::scaled(kResetWidth));
    QSizePolicy stays = reset_->sizePolicy();
    stays.setRetainSizeWhenHidden(true);
    reset_->setSizePolicy(stays);
    connect(reset_, &QToolButton::clicked, this, &SceneFieldRow::reset);
    const int row = grid.rowCount();
    const bool isWide = field.input == SceneInput::Steps;  // a list with buttons, below its caption
    grid.addWidget(caption_, row, 0);
    grid.addWidget(reset_, row, 2);
    grid.addWidget(control_, isWide ? row + 1 : row, isWide ? 0 : 1, 1, isWide ? 3 : 1);
    refuse({});
    theme::follow(this, [this] { setMuted(muted_); });
}

QWidget* SceneFieldRow::newControl(QWidget* parent) {
    switch (field_.input) {
    case SceneInput::Number:
    case SceneInput::Whole:
        return newNumber(parent);
    case SceneInput::Switch:
        return newSwitch(parent);
    case SceneInput::Choice:
        return newChoice(parent);
    case SceneInput::Steps:
        return newLeveling(parent);
    case SceneInput::Text:
    case SceneInput::File:
    case SceneInput::Places:
        break;
    }
    return newText(parent);
}

QWidget* SceneFieldRow::newNumber(QWidget* parent) {
    NumberBox* box = newBox(field_, parent);
    box->setMinimumWidth(theme::scaled(kFieldWidth));
    guardFromWheel(*box);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this](double number) { Q_EMIT entered(fromUnit(number, field_.words.scale)); });
    showValue_ = [this, box](const SceneDescription& scene) {
        const QSignalBlocker blocker(box);
        const double number = std::get<double>(field_.get(scene)) / field_.words.scale;
        box->setRange(std::min(box->minimum(), number), std::max(box->maximum(), number));
        box->setValue(number);
    };
    return box;
}

QWidget* SceneFieldRow::newSwitch(QWidget* parent) {
    auto* box = new QCheckBox(parent);
    connect(box, &QCheckBox::clicked, this, [this](bool on) { Q_EMIT entered(on); });
    showValue_ = [this, box](const SceneDescription& scene) {
        box->setChecked(std::get<bool>(field_.get(scene)));
    };
    return box;
}

QWidget* SceneFieldRow::newChoice(QWidget* parent) {
    auto* box = new ChoiceBox(parent);
    guardFromWheel(*box);
    connect(box, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        Q_EMIT entered(choices_.at(static_cast<std::size_t>(index)).key);
    });
    showValue_ = [this, box](const SceneDescription& scene) {
        const auto value = std::get<std::string>(field_.get(scene));
        QStringList names;
        int present = -1;
        for (const SceneChoice& choice : choices_) {
            present = choice.key == value ? names.size() : present;
            names << coreWords(choice.name);
        }
        box->setNames(names);
        box->setCurrentIndex(present);
    };
    return box;
}

QWidget* SceneFieldRow::newText(QWidget* parent) {
    auto* line = new TextBox(parent);
    line->setReadOnly(field_.input == SceneInput::File);
    line->setMinimumWidth(theme::scaled(kFieldWidth));
    connect(line, &QLineEdit::editingFinished, this, [this, line] { enterText(*line); });
    showValue_ = [this, line](const SceneDescription& scene) {
        shownText_ = QString::fromStdString(std::get<std::string>(field_.get(scene)));
        line->setText(shownText_);
    };
    return line;
}

QWidget* SceneFieldRow::newLeveling(QWidget* parent) {
    auto* editor = new LevelingEditor(parent);
    connect(editor, &LevelingEditor::edited, this, [this, editor] {
        const LevelingSteps steps = editor->steps();
        const std::optional<LevelPoints> places = editor->points();
        Q_EMIT levelingEntered(steps, places);
    });
    showValue_ = [editor](const SceneDescription& scene) {
        editor->setLeveling(scene.sample.leveling, scene.sample.levelPoints);
    };
    return editor;
}

void SceneFieldRow::setScanSize(const QSizeF& size) {
    if (auto* const editor = qobject_cast<LevelingEditor*>(control_)) {
        editor->setScanSize(size);
    }
}

void SceneFieldRow::reset() {
    if (field_.input == SceneInput::Steps) {
        const SampleDescription sample = defaults_.sample;
        Q_EMIT levelingEntered(sample.leveling, sample.levelPoints);
    } else {
        Q_EMIT entered(field_.get(defaults_));
    }
}

void SceneFieldRow::enterText(QLineEdit& line) {
    if (line.isReadOnly() || line.text() == shownText_) {
        return;
    }
    const std::string text = line.text().toStdString();
    const std::string refusal = field_.refusal == nullptr ? std::string() : field_.refusal(text);
    if (!refusal.empty()) {
        line.setText(shownText_);
        Q_EMIT refused(tr("“%1” is not taken: it must be %2")
                           .arg(QString::fromStdString(text), coreWords(refusal)));
        return;
    }
    shownText_ = line.text();
    Q_EMIT entered(text);
}

void SceneFieldRow::setChoices(const std::vector<SceneChoice>& choices) { choices_ = choices; }

void SceneFieldRow::show(const SceneDescription& scene, const SceneDescription& defaults) {
    defaults_ = defaults;
    showValue_(scene);
    const bool isDefault = isSame(field_, scene, defaults);
    reset_->setVisible(!isDefault);
    muted_ = isDefault;
    setMuted(muted_);
    refuse(coreWords(whyIdle(field_, scene)));
}

void SceneFieldRow::setMuted(bool muted) {
    if (auto* const box = qobject_cast<NumberBox*>(control_)) {
        box->setMuted(muted);
        return;
    }
    const QColor color = muted ? theme::colors().muted : theme::colors().ink;
    QPalette colors = control_->palette();
    colors.setColor(QPalette::Active, QPalette::Text, color);
    colors.setColor(QPalette::Inactive, QPalette::Text, color);
    control_->setPalette(colors);
}

void SceneFieldRow::refuse(const QString& reason) {
    const QString usual = coreWords(field_.words.toolTip);
    caption_->setToolTip(reason.isEmpty() ? usual : reason);
    control_->setToolTip(reason.isEmpty() ? usual : reason);
    control_->setEnabled(reason.isEmpty());
    reset_->setEnabled(reason.isEmpty());
    reset_->setToolTip(tr("Back to the default of a scene that does not say %1")
                           .arg(QString::fromUtf8(field_.key)));
}

}  // namespace asperity
