#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/PixelRectangle.h"
#include "core/surface/ScaleGap.h"
#include "core/surface/leveling/LevelingStep.h"

#include <QImage>
#include <QSize>
#include <QSizeF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace asperity {

/// What of a file is opened, and how.
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

/// What the dialog shows of a file that may be opened.
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

}  // namespace asperity
