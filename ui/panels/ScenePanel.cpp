#include "ui/panels/ScenePanel.h"

#include "ui/CoreWords.h"
#include "ui/panels/Card.h"
#include "ui/panels/ChoiceBox.h"
#include "ui/panels/LibraryBar.h"
#include "ui/panels/SceneFieldRow.h"
#include "ui/panels/Section.h"
#include "ui/panels/WheelGuard.h"

#include <QGridLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <string_view>

namespace asperity {

namespace {

constexpr int kSceneGap = 6;  ///< [px]

/// What a section is about, and whether it is folded at first.
struct SectionTraits {
    SceneGroup value;
    const char* about;
    bool folded;
};

constexpr auto kSections = std::to_array<SectionTraits>(
    {{SceneGroup::Sample, "The scan and what is done to it on load", false},
     {SceneGroup::Shape, "An exact shape in place of the scan", true},
     {SceneGroup::Material, "What the model takes the sample to be", false},
     {SceneGroup::Tip, "The sphere that ends the tip", false},
     {SceneGroup::Probe, "The cantilever and its calibration", false},
     {SceneGroup::Truth, "What the simulated instrument really is", true},
     {SceneGroup::Physics, "Contact law and meniscus", true},
     {SceneGroup::Fidelity, "What the model leaves out and how it is solved", true},
     {SceneGroup::Uncertainty, "How well the scene's numbers are known", true},
     {SceneGroup::Approach, "Where an approach ends", true},
     {SceneGroup::View, "What the large view shows at first", true}});

}  // namespace

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
            if (field.group != traits.value || field.input == SceneInput::Places) {
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
    open->setToolTip(tr("Open another scan or scene; the same as File > Open"));
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
    link->setToolTip(
        tr("Open View > Fidelity: what leaving out a term changes, and what it costs"));
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
