#include "app/window/scene/PreviewPane.h"

#include "app/window/scene/CropFields.h"
#include "app/window/scene/LevelingEditor.h"
#include "app/window/scene/ScaleControl.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cmath>

namespace asperity {

namespace {

constexpr int kPaneGap = 8;        // [px]
constexpr int kShownChannels = 4;  // without scrolling, where there is room
constexpr int kMinChannels = 2;    // same, where there is none
constexpr int kNotesLines = 4;     // where there is room
constexpr int kMinNotesLines = 2;  // where there is none
constexpr int kFactsWidth = 200;   // their values seldom wrap [px, as theme::scaled() takes them]
constexpr int kWhole = 100;        // of the bar [%]

enum ChannelColumn : int { Name, Unit, Direction, Pixels, ColumnCount };

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setFont(theme::boldFont());
    return label;
}

QVBoxLayout* newPaneColumn(QWidget& part) {
    auto* column = new QVBoxLayout(&part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kPaneGap / 2);
    return column;
}

/// A picture below its caption.
QWidget* captioned(const QString& caption, QWidget* picture, QWidget* parent) {
    auto* part = new QWidget(parent);
    QVBoxLayout* column = newPaneColumn(*part);
    column->addWidget(captionLabel(caption, part));
    column->addWidget(picture, 1);
    return part;
}

}  // namespace

PreviewPane::PreviewPane(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kPaneGap);
    column->addWidget(newChannels());
    column->addWidget(newPictures(), 1);
    column->addWidget(newInputs());
    scale_ = new ScaleForm(Qt::Horizontal, this);
    scale_->setObjectName(QStringLiteral("previewScale"));
    column->addWidget(scale_);
    notes_ = new QPlainTextEdit(this);
    notes_->setObjectName(QStringLiteral("previewNotes"));
    notes_->setReadOnly(true);
    notes_->setFont(theme::textFont(theme::kSmallSize));
    notes_->setToolTip(
        tr("Decisions of the reader about the file, and the sources of its numbers"));
    const auto notesHeight = [this](int lines) {
        return lines * notes_->fontMetrics().lineSpacing() + 2 * kPaneGap;
    };
    notes_->setMinimumHeight(notesHeight(kMinNotesLines));
    notes_->setMaximumHeight(notesHeight(kNotesLines));
    column->addWidget(notes_);
    connectInputs();
    clear({});
}

QWidget* PreviewPane::newChannels() {
    channels_ = new QTreeWidget(this);
    channels_->setObjectName(QStringLiteral("previewChannels"));
    channels_->setToolTip(tr("Channels of the file; the chosen one is opened. Gray: no height"));
    channels_->setColumnCount(ColumnCount);
    channels_->setHeaderLabels({tr("Channel"), tr("Unit"), tr("Direction"), tr("Pixels")});
    channels_->setRootIsDecorated(false);
    channels_->setUniformRowHeights(true);
    channels_->header()->setStretchLastSection(false);
    channels_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    channels_->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    const int line = channels_->fontMetrics().lineSpacing() + kPaneGap / 2;
    channels_->setMinimumHeight((kMinChannels + 1) * line + kPaneGap);
    channels_->setMaximumHeight((kShownChannels + 1) * line + kPaneGap);
    return channels_;
}

QWidget* PreviewPane::newPictures() {
    auto* part = new QWidget(this);
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kPaneGap);
    before_ = new CropPicture(part);
    before_->setObjectName(QStringLiteral("previewBefore"));
    before_->setDrawable(true);
    before_->setToolTip(
        tr("The scan as in the file, colored by height. Drag a rectangle to load only "
           "that part; a click clears it"));
    after_ = new CropPicture(part);
    after_->setObjectName(QStringLiteral("previewAfter"));
    after_->setToolTip(tr("The part to load, leveled, colored by height"));
    progress_ = new QProgressBar(part);
    progress_->setObjectName(QStringLiteral("previewProgress"));
    progress_->setRange(0, kWhole);
    progress_->setFixedHeight(theme::scaled(kPaneGap));
    progress_->setTextVisible(false);
    progress_->setToolTip(tr("Progress of reading the file"));
    QSizePolicy policy = progress_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(policy);
    grid->addWidget(captioned(tr("As recorded"), before_, part), 0, 0);
    grid->addWidget(captioned(tr("Leveled"), after_, part), 0, 1);
    grid->addWidget(progress_, 1, 0, 1, 2);
    progress_->hide();
    return part;
}

QWidget* PreviewPane::newFacts() {
    auto* part = new QWidget(this);
    part->setMinimumWidth(theme::scaled(kFactsWidth));
    facts_ = new QGridLayout(part);
    facts_->setContentsMargins(0, 0, 0, 0);
    facts_->setHorizontalSpacing(kPaneGap);
    facts_->setVerticalSpacing(2);
    facts_->setColumnStretch(1, 1);
    return part;
}

QWidget* PreviewPane::newInputs() {
    auto* part = new QWidget(this);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2 * kPaneGap);
    row->addWidget(newFacts(), 1, Qt::AlignTop);
    auto* steps = new QWidget(part);
    QVBoxLayout* stepsColumn = newPaneColumn(*steps);
    leveling_ = new LevelingEditor(steps);
    stepsColumn->addWidget(heading(tr("Leveling"), steps));
    stepsColumn->addWidget(leveling_, 1);
    row->addWidget(steps);
    auto* rest = new QWidget(part);
    QVBoxLayout* restColumn = newPaneColumn(*rest);
    crop_ = new CropFields(rest);
    restColumn->addWidget(heading(tr("Part to load"), rest));
    restColumn->addWidget(crop_);
    restColumn->addStretch();
    row->addWidget(rest);
    return part;
}

void PreviewPane::connectInputs() {
    connect(channels_, &QTreeWidget::currentItemChanged, this, &PreviewPane::chooseChannel);
    connect(before_, &CropPicture::cropDragged, crop_, &CropFields::setCrop);
    connect(before_, &CropPicture::cropDrawn, this, &PreviewPane::crop);
    connect(crop_, &CropFields::cropEntered, this, &PreviewPane::crop);
    connect(leveling_, &LevelingEditor::edited, this, [this] {
        choices_.leveling = leveling_->steps();
        choices_.levelPoints = leveling_->points();
        Q_EMIT choicesChanged();
    });
    connect(scale_, &ScaleForm::changed, this, [this] {
        if (isShown_) {
            choices_.scale = scale_->isComplete() ? scale_->scale() : GivenScale();
            Q_EMIT choicesChanged();
        }
    });
}

void PreviewPane::clear(const QString& words) {
    isShown_ = false;
    shown_ = {};
    choices_ = {};
    scale_->setGap({});
    for (CropPicture* const picture : {before_, after_}) {
        picture->setPicture({}, {}, {});
        picture->setWords({});
    }
    before_->setWords(words);
    showPreview({});
    isShown_ = false;
}

void PreviewPane::showPreview(const OpenPreview& preview) {
    isShown_ = false;
    shown_ = preview;
    showChannels();
    before_->setPicture(preview.before, preview.pixels, preview.size);
    before_->setCrop(preview.crop);
    before_->setDrawable(preview.isMap);
    const PixelRectangle part = preview.crop.value_or(
        PixelRectangle{0, 0, preview.pixels.width(), preview.pixels.height()});
    const QSizeF size = preview.size.isEmpty()
                            ? QSizeF()
                            : QSizeF(preview.size.width() * part.columns / preview.pixels.width(),
                                     preview.size.height() * part.rows / preview.pixels.height());
    after_->setPicture(preview.after, {part.columns, part.rows}, size);
    showFacts();
    leveling_->setScanSize(size);
    leveling_->setLeveling(preview.leveling, preview.levelPoints);
    crop_->showScan(preview.pixels, preview.size, preview.crop);
    for (QWidget* const input : {static_cast<QWidget*>(leveling_), static_cast<QWidget*>(crop_)}) {
        input->setEnabled(preview.isMap && !preview.before.isNull());
    }
    scale_->setGap(preview.gap.value_or(ScaleGap()));
    scale_->setVisible(preview.gap.has_value());
    notes_->setPlainText(preview.notes.join('\n'));
    isShown_ = true;
}

void PreviewPane::refuse(const QString& reason) {
    shown_.refusal = reason;
    before_->setWords(tr("No preview"));
    after_->setPicture({}, {}, {});
}

void PreviewPane::showChannels() {
    const QSignalBlocker blocker(channels_);
    channels_->clear();
    for (const OpenChannel& channel : shown_.channels) {
        auto* row = new QTreeWidgetItem(
            channels_, {channel.name, channel.unit, channel.direction,
                        tr("%1 × %2").arg(channel.pixels.width()).arg(channel.pixels.height())});
        for (int column = 0; !channel.opens && column < ColumnCount; ++column) {
            row->setForeground(column, theme::colors().muted);
        }
        if (channel.name == shown_.channel) {
            channels_->setCurrentItem(row);
        }
    }
    channels_->setEnabled(!shown_.channels.empty());
}

/// The labels stay from one file to the next.
void PreviewPane::showFacts() {
    for (const auto& [name, value] : values_) {
        value->clear();
    }
    for (const OpenFact& fact : shown_.facts) {
        QLabel*& value = values_[QString::fromUtf8(fact.name)];
        if (value == nullptr) {
            const int row = facts_->rowCount();
            QLabel* caption = captionLabel(fact.caption, facts_->parentWidget());
            value = new QLabel(facts_->parentWidget());
            value->setObjectName(QString::fromUtf8(fact.name));
            value->setTextFormat(Qt::PlainText);
            value->setTextInteractionFlags(Qt::TextSelectableByMouse);
            value->setWordWrap(true);
            caption->setToolTip(fact.tip);
            value->setToolTip(fact.tip);
            facts_->addWidget(caption, row, 0, Qt::AlignTop);
            facts_->addWidget(value, row, 1);
        }
        value->setText(fact.value);
    }
}

void PreviewPane::chooseChannel() {
    const int row = channels_->indexOfTopLevelItem(channels_->currentItem());
    if (row < 0) {
        return;
    }
    const OpenChannel& channel = shown_.channels.at(static_cast<std::size_t>(row));
    choices_.channel = channel.name;
    if (channel.pixels != shown_.pixels) {
        choices_.crop.reset();
    }
    Q_EMIT choicesChanged();
}

/// All of the scan is said, too: the scene may crop it.
void PreviewPane::crop(const std::optional<PixelRectangle>& crop) {
    choices_.crop =
        crop.value_or(PixelRectangle{0, 0, shown_.pixels.width(), shown_.pixels.height()});
    before_->setCrop(crop);
    crop_->setCrop(crop);
    Q_EMIT choicesChanged();
}

void PreviewPane::setProgress(const std::optional<double>& fraction) {
    progress_->setVisible(fraction.has_value());
    progress_->setValue(static_cast<int>(std::floor(kWhole * fraction.value_or(0.0))));
}

void PreviewPane::suggest(const GivenScale& scale) { scale_->suggest(scale); }

bool PreviewPane::isComplete() const {
    return isShown_ && !shown_.before.isNull() && shown_.refusal.isEmpty() &&
           (!shown_.gap || scale_->isComplete());
}

}  // namespace asperity
