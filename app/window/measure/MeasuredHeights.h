#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "core/surface/HeightMap.h"
#include "core/surface/measure/Profile.h"

#include <QCheckBox>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace asperity {

/// Heights that the measuring pages read: those of the leveled scan, or those of the surface that
/// the tip touches. Safe to read from any thread.
class MeasuredScan {
public:
    using Leveled = std::variant<HeightMap, ScanMap>;

    /// @param leveled null: the surface passes through the leveled heights
    /// @param isSmoothed the surface is to be read, whatever its heights are
    MeasuredScan(std::shared_ptr<const LoadedScene> loaded, std::shared_ptr<const Leveled> leveled,
                 bool isSmoothed);
    ~MeasuredScan() = default;
    MeasuredScan(const MeasuredScan&) = delete;
    MeasuredScan& operator=(const MeasuredScan&) = delete;

    [[nodiscard]] HeightRows rows() const;
    [[nodiscard]] const HeightField& field() const { return field_; }
    /// Returns leveling and smoothing of the heights, in words.
    [[nodiscard]] const QString& leveling() const { return leveling_; }
    [[nodiscard]] const QString& smoothing() const { return smoothing_; }
    /// Returns how sure the scanner's calibration is, in words; empty: the scene leaves that out.
    [[nodiscard]] QString calibration() const;
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] const std::string& channel() const { return channel_; }
    /// Returns the comments of a table of these heights. @param what it has, "profiles"
    [[nodiscard]] std::vector<std::string> provenance(const std::string& what) const;

private:
    std::shared_ptr<const LoadedScene> loaded_;
    std::shared_ptr<const Leveled> leveledScan_;
    HeightField field_;
    std::string name_;  ///< with channel and crop, for people
    std::string file_;
    std::string channel_;
    QString leveling_;
    QString smoothing_;
};

/// Provides the heights for all measuring pages: by default those of the leveled scan, which is
/// read once, in the background, where the surface that the tip touches has others.
class MeasuredHeights : public Feature {
    Q_OBJECT

public:
    explicit MeasuredHeights(Stage& stage);

    /// Returns the heights of the present scan; null while there are none: state() says why, and
    /// changed() follows where they are being read. Begins to read them where that is needed.
    [[nodiscard]] std::shared_ptr<const MeasuredScan> scan();
    /// Returns why there are no heights, in words.
    [[nodiscard]] const QString& state() const { return state_; }
    /// Lets a page's box choose the heights of all pages.
    void follow(QCheckBox& smoothed);

Q_SIGNALS:
    /// The heights are others, or there are some now, or another share of them was read.
    void changed();
    void smoothedChosen(bool smoothed);

private:
    void begin();
    void setSmoothed(bool smoothed);
    void setState(const QString& words);

    bool isSmoothed_ = false;
    std::optional<SampleDescription> source_;  ///< what is read, was read or failed
    std::string hash_;                         ///< of its file
    std::shared_ptr<const MeasuredScan::Leveled> leveled_;
    QString state_;
    BackgroundWork<MeasuredScan::Leveled> reading_;
};

/// Returns the box that chooses whether the surface that the tip touches is measured.
[[nodiscard]] QCheckBox* newSmoothedBox(const char* name, QWidget* parent);

}  // namespace asperity
