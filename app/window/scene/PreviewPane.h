#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/HeightMap.h"
#include "core/surface/leveling/LevelingStep.h"

#include <QImage>
#include <QSize>
#include <QSizeF>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <map>
#include <optional>
#include <vector>

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

/// Choices for opening a file: which part of it, and how.
struct OpenChoices {
    QString channel;                         ///< empty: the one that a lab user expects
    std::optional<LevelingSteps> leveling;   ///< none: as the scene says
    std::optional<LevelPoints> levelPoints;  ///< of the step three_point
    std::optional<PixelRectangle> crop;      ///< none: as the scene says
    GivenScale scale;                        ///< of a file that does not say its own
};

/// A channel as a row of the list.
struct OpenChannel {
    QString name;
    QString unit;
    QString direction;
    QSize pixels;
    bool opens = false;  ///< it is a height, or may be one
};

/// A number of the preview with its caption and meaning.
struct OpenFact {
    const char* name;  ///< of the label that shows it
    QString caption;
    QString value;
    QString tip;
};

/// Preview of a file that may be opened.
struct OpenPreview {
    QString format;
    std::vector<OpenChannel> channels;
    QString channel;  ///< the one that is shown
    QSize pixels;
    QSizeF size;  ///< [m]; empty: not known
    std::optional<ScaleGap> gap;
    bool isMap = true;  ///< there is something to level and to crop
    LevelingSteps leveling;
    std::optional<LevelPoints> levelPoints;
    std::optional<PixelRectangle> crop;
    QImage before;  ///< of all of the scan
    QImage after;   ///< of the crop, leveled; null: there is none
    std::vector<OpenFact> facts;
    QStringList notes;
    QString refusal;  ///< why it cannot be opened so; empty: it can, but for a gap
};

/// A file that was opened before.
struct RecentFile {
    QString path;  ///< for people
    QString name;  ///< without its folder
    bool isThere = true;
};

/// Content of a file before it is opened: its channels, pictures before and after leveling, numbers
/// and notes; and choices for opening it: channel, leveling, crop, and the scale that it does not
/// hold.
class PreviewPane : public QWidget {
    Q_OBJECT

public:
    explicit PreviewPane(QWidget* parent = nullptr);

    /// Another file, or none, with nothing known of it yet. @param words instead of a picture
    void clear(const QString& words);
    void showPreview(const OpenPreview& preview);
    /// Shows why the file, or the chosen part, cannot be previewed. What was known of it stays,
    /// so that something else can be chosen.
    void refuse(const QString& reason);
    /// Shows the progress of reading the file, 0..1; none: it is done, or quick.
    void setProgress(const std::optional<double>& fraction);
    /// Fills in what is missing of the scale, as it was given for another scan.
    void suggest(const GivenScale& scale);

    [[nodiscard]] const OpenChoices& choices() const { return choices_; }
    /// Returns whether the file that is shown can be opened with these choices.
    [[nodiscard]] bool isComplete() const;

Q_SIGNALS:
    /// The user has changed choices() or isComplete().
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
