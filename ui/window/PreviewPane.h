#pragma once

#include "ui/window/OpenPreview.h"

#include <QWidget>

#include <map>

class QGridLayout;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QTreeWidget;

namespace asperity {

class CropFields;
class CropPicture;
class LevelingEditor;
class ScaleForm;

/// What a file holds, before it is opened: its channels, pictures before and after leveling,
/// numbers and notes; and what to open of it: channel, leveling, crop, and the scale that it does
/// not hold.
class PreviewPane : public QWidget {
    Q_OBJECT

public:
    explicit PreviewPane(QWidget* parent = nullptr);

    /// Another file, or none, with nothing known of it yet. @param words in place of a picture
    void clear(const QString& words);
    void showPreview(const OpenPreview& preview);
    /// Why the file, or what was chosen of it, cannot be looked into. What was known of it stays,
    /// so that something else can be chosen.
    void refuse(const QString& reason);
    /// How far looking into the file is, 0..1; none: it is done, or quick.
    void setProgress(const std::optional<double>& fraction);
    /// Fills in what is missing of the scale, as it was given for another scan.
    void suggest(const GivenScale& scale);

    [[nodiscard]] const OpenChoices& choices() const { return choices_; }
    /// What is shown can be opened with these choices.
    [[nodiscard]] bool isComplete() const;

Q_SIGNALS:
    /// By the user: choices() or isComplete() are others.
    void choicesChanged();

private:
    [[nodiscard]] QWidget* newChannels();
    [[nodiscard]] QWidget* newPictures();
    [[nodiscard]] QWidget* newInputs();
    [[nodiscard]] QWidget* newFacts();
    void connectInputs();
    void showChannels();
    void showFacts();
    void chooseChannel();
    void crop(const std::optional<PixelRectangle>& crop);

    OpenPreview shown_;
    bool isShown_ = false;
    OpenChoices choices_;
    QTreeWidget* channels_ = nullptr;
    CropPicture* before_ = nullptr;
    CropPicture* after_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QGridLayout* facts_ = nullptr;
    std::map<QString, QLabel*> values_;  ///< of the facts, by their names
    LevelingEditor* leveling_ = nullptr;
    CropFields* crop_ = nullptr;
    ScaleForm* scale_ = nullptr;
    QPlainTextEdit* notes_ = nullptr;
};

}  // namespace asperity
