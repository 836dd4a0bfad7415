#include "app/window/scene/ScenePanel.h"

#include "app/window/scene/LevelingEditor.h"
#include "app/window/scene/LibraryControl.h"
#include "core/Error.h"
#include "core/scene/SceneFieldChange.h"
#include "core/words/SceneWords.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>
#include <string_view>

namespace asperity {

namespace {

constexpr int kFieldWidth = 96;  ///< of a number, at least [px]
constexpr int kResetWidth = 22;  ///< [px]
constexpr int kFieldDecimals = 12;
constexpr int kShownSizeDigits = 4;  ///< of the size of a scan

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

constexpr int kSceneGap = 6;  ///< [px]

/// What a section is about, and whether it is folded at first.
struct SectionTraits {
    SceneGroup value;
    const char* about;
    bool folded;
};

constexpr auto kSections = std::to_array<SectionTraits>(
    {{SceneGroup::Sample, "The scan and its processing on load", false},
     {SceneGroup::Shape, "An exact shape instead of the scan", true},
     {SceneGroup::Material, "The sample as the model assumes it", false},
     {SceneGroup::Tip, "The sphere that ends the tip", false},
     {SceneGroup::Probe, "The cantilever and its calibration", false},
     {SceneGroup::Truth, "The simulated instrument as it really is", true},
     {SceneGroup::Physics, "Contact law and meniscus", true},
     {SceneGroup::Fidelity, "Terms left out of the model, and solvers", true},
     {SceneGroup::Uncertainty, "How well the scene's numbers are known", true},
     {SceneGroup::Approach, "Where an approach ends", true},
     {SceneGroup::View, "Initial width of the large view", true}});

}  // namespace

ScenePanelControl::ScenePanelControl(Stage& stage)
    : Feature(stage), panel_(new ScenePanel(&host_.widget())) {
    host_.addSidePage(panel_, tr("Scene"));
    Menus& menus = host_.menus();
    const QAction& entry =
        menus.add({MenuName::View, 3, 20}, "parameters",
                  {.text = tr("Sce&ne"),
                   .tip = tr("Every key of the scene: scan, material, tip, lever, physics"),
                   .shortcuts = {tr("F7")}});
    connect(&entry, &QAction::triggered, this, [this] { host_.showSidePage(panel_); });
    ScenePanel& panel = *panel_;
    connect(&panel, &ScenePanel::refused, this,
            [this](const QString& reason) { host_.tell(reason, MessageKind::Warning); });
    connect(&panel, &ScenePanel::valueEntered, this, &ScenePanelControl::enter);
    connect(&panel, &ScenePanel::levelingEntered, this, &ScenePanelControl::level);
    connect(&panel, &ScenePanel::openRequested, this, [&menus] { menus.entry("open").trigger(); });
    connect(&panel, &ScenePanel::fidelityRequested, this,
            [&menus] { menus.entry("fidelity").trigger(); });
    connect(&runs_, &RunControl::begun, this, &ScenePanelControl::show);
    connect(&edits_, &SceneEdits::changed, this, &ScenePanelControl::show);
}

void ScenePanelControl::enter(const SceneField& field, const SceneValue& value) {
    const SceneDescription* const now = edits_.wanted();
    if (now == nullptr) {
        return;
    }
    try {
        const SceneDescription next = withValue(*now, field, value, panel_->calibration());
        edits_.change(QString::fromStdString(changeText(field, next)), next,
                      QString::fromStdString(nameOf(field)));
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
        show();
    }
}

void ScenePanelControl::level(const LevelingSteps& steps,
                              const std::optional<LevelPoints>& points) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.sample.leveling = steps;
        next.sample.levelPoints = points;
        edits_.change(tr("Leveling: %1").arg(QString::fromStdString(textOf(steps))), next);
    }
}

void ScenePanelControl::show() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        QStringList channels;
        for (const std::string& name : runs_.loaded().channels) {
            channels << QString::fromStdString(name);
        }
        const BSplineSurface& surface = runs_.scene().surface;
        panel_->setScanSize({surface.sizeX(), surface.sizeY()});
        panel_->setChannels(channels);
        panel_->showScene(*scene, defaultsOf(*scene));
    }
}

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
    case SceneInput::Positions:
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
        const std::optional<LevelPoints> points = editor->points();
        Q_EMIT levelingEntered(steps, points);
    });
    showValue_ = [editor](const SceneDescription& scene) {
        editor->setLeveling(scene.sample.leveling, scene.sample.levelPoints);
    };
    return editor;
}

void SceneFieldRow::setScanSize(const QSizeF& size) {
    scanSize_ = size;
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
        Q_EMIT refused(tr("“%1” is not valid: it must be %2")
                           .arg(QString::fromStdString(text), coreWords(refusal)));
        return;
    }
    shownText_ = line.text();
    Q_EMIT entered(text);
}

void SceneFieldRow::setChoices(const std::vector<SceneChoice>& choices) { choices_ = choices; }

void SceneFieldRow::show(const SceneDescription& scene, const SceneDescription& defaults) {
    defaults_ = defaults;
    showZero(scene);
    showValue_(scene);
    const bool isDefault = isSame(field_, scene, defaults);
    reset_->setVisible(!isDefault);
    muted_ = isDefault;
    setMuted(muted_);
    refuse(coreWords(whyIdle(field_, scene)));
}

/// A width of 0 stands for that of the file: it says which one that is.
void SceneFieldRow::showZero(const SceneDescription& scene) {
    const std::string_view key = field_.key;
    const bool isWidth = key == "size_x_m";
    if (!isWidth && key != "size_y_m") {
        return;
    }
    const double size = isWidth ? scanSize_.width() : scanSize_.height();
    const bool isKnown = size > 0.0 && !scene.sample.crop;  // of the whole scan
    const QString number = QString::number(size / field_.words.scale, 'g', kShownSizeDigits);
    static_cast<NumberBox*>(control_)->setSpecialValueText(isKnown ? tr("%1 (file)").arg(number)
                                                                   : tr("as in the file"));
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

ScenePanel::ScenePanel(QWidget* parent)
    : QWidget(parent)
    , page_(new QWidget(this))
    , materials_(new LibraryBar(tr("material"), this))
    , probes_(new LibraryBar(tr("probe"), this))
    , calibration_(new ChoiceBox(this)) {
    auto* around = new QVBoxLayout(this);
    around->setContentsMargins(0, 0, 0, 0);
    around->addWidget(page_);
    column_ = new QVBoxLayout(page_);
    column_->setContentsMargins(kSceneGap, kSceneGap, kSceneGap, kSceneGap);
    column_->setSpacing(kSceneGap);
    addRows();
    column_->addStretch();
    setToolTip(tr("Every key of the scene, in the units of a lab"));
    page_->setEnabled(false);
}

Section& ScenePanel::newSection(SceneGroup group) {
    const SectionTraits& traits = kSections.at(static_cast<std::size_t>(group));
    auto* section = new Section(coreWords(nameOf(group)), coreWords(traits.about), this);
    section->setObjectName(QStringLiteral("section") + QString::fromUtf8(nameOf(group)));
    section->setFolded(traits.folded);
    column_->addWidget(section);
    sections_[group] = section;
    if (group == SceneGroup::Material) {
        section->addWide(materials_);
    } else if (group == SceneGroup::Probe) {
        section->addWide(probes_);
        addCalibration(*section);
    } else if (group == SceneGroup::Fidelity) {
        addFidelityLink(*section);
    } else if (group == SceneGroup::Sample) {
        addOpening(*section);
    }
    return *section;
}

void ScenePanel::addRows() {
    for (const SectionTraits& traits : kSections) {
        Section& section = newSection(traits.value);
        for (const SceneField& field : sceneFields()) {
            if (field.group != traits.value || field.input == SceneInput::Positions) {
                continue;
            }
            auto* row = new SceneFieldRow(field, section.rows(), &section);
            rows_.push_back(row);
            connect(row, &SceneFieldRow::levelingEntered, this, &ScenePanel::levelingEntered);
            connect(row, &SceneFieldRow::refused, this, &ScenePanel::refused);
            connect(row, &SceneFieldRow::entered, this,
                    [this, &field](const SceneValue& value) { Q_EMIT valueEntered(field, value); });
        }
    }
}

void ScenePanel::addOpening(Section& section) {
    auto* open = new QPushButton(tr("Open another scan…"), this);
    open->setObjectName(QStringLiteral("openScan"));
    open->setToolTip(tr("The same as File > Open scan or scene…"));
    section.addWide(open);
    connect(open, &QPushButton::clicked, this, &ScenePanel::openRequested);
}

void ScenePanel::addCalibration(Section& section) {
    QStringList names;
    for (const auto& row : kEnumTable<LeverCalibration>) {
        names << coreWords(row.name);
    }
    calibration_->setObjectName(QStringLiteral("calibratedBy"));
    calibration_->setNames(names);
    calibration_->setCurrentIndex(static_cast<int>(LeverCalibration::Stiffness));
    calibration_->setToolTip(
        tr("What was measured of the lever: it stays when length, width, density or modulus "
           "change. With stiffness and resonance, thickness and modulus follow"));
    guardFromWheel(*calibration_);
    QGridLayout& rows = section.rows();
    const int row = rows.rowCount();
    auto* caption = captionLabel(tr("Measured"), this);
    caption->setToolTip(calibration_->toolTip());
    rows.addWidget(caption, row, 0);
    rows.addWidget(calibration_, row, 1);
}

void ScenePanel::addFidelityLink(Section& section) {
    auto* link = new QPushButton(tr("What each term costs (F6)…"), this);
    link->setObjectName(QStringLiteral("showFidelity"));
    link->setToolTip(tr("Open View > Fidelity: effect and cost of each term"));
    section.addWide(link);
    connect(link, &QPushButton::clicked, this, &ScenePanel::fidelityRequested);
}

LeverCalibration ScenePanel::calibration() const {
    return kEnumTable<LeverCalibration>.at(static_cast<std::size_t>(calibration_->currentIndex())).value;
}

void ScenePanel::setScanSize(const QSizeF& size) {
    for (SceneFieldRow* row : rows_) {
        row->setScanSize(size);
    }
}

void ScenePanel::setChannels(const QStringList& names) {
    std::vector<SceneChoice> choices;
    for (const QString& name : names) {
        choices.push_back({name.toStdString(), name.toStdString()});
    }
    for (SceneFieldRow* row : rows_) {
        if (std::string_view(row->field().key) == "channel") {
            row->setChoices(choices);
        }
    }
}

void ScenePanel::showScene(const SceneDescription& scene, const SceneDescription& defaults) {
    page_->setEnabled(true);
    for (SceneFieldRow* row : rows_) {
        row->show(scene, defaults);
    }
}

}  // namespace asperity
