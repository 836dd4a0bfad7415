#include "app/window/measure/MeasuredHeights.h"

#include "app/loading/SceneLoader.h"
#include "core/Version.h"
#include "core/surface/measure/Roughness.h"
#include "core/words/SceneWords.h"
#include "ui/widgets/PageParts.h"

#include <cmath>
#include <utility>

namespace asperity {

namespace {

QString levelingText(const SampleDescription& sample) {
    return QString::fromStdString(textOf(sample.leveling)).replace('_', ' ');
}

/// Returns whether the surface has other heights than the leveled scan, which its file still has.
bool hasOtherHeights(const SampleDescription& sample) {
    return !sample.shape && (sample.erode || sample.smoothingLength > 0.0 ||
                             sample.smoothingPixels.value_or(0.0) > 0.0);
}

QString smoothingText(const SampleDescription& sample) {
    const double pixels = sample.smoothingPixels.value_or(0.0);
    QStringList parts;
    if (sample.erode) {
        parts << MeasuredHeights::tr("imaging tip removed");
    }
    if (sample.smoothingLength > 0.0) {
        parts << MeasuredHeights::tr("Gaussian, standard deviation %1 nm")
                     .arg(1e9 * sample.smoothingLength, 0, 'g', 3);
    } else if (pixels > 0.0) {
        parts << MeasuredHeights::tr("Gaussian, standard deviation %1 px").arg(pixels, 0, 'g', 3);
    }
    return parts.isEmpty() ? MeasuredHeights::tr("none") : parts.join(QStringLiteral("; "));
}

/// Returns the keys of a sample that change its leveled heights; the others have their defaults.
SampleDescription sourceOf(SampleDescription sample) {
    const SampleDescription usual;
    sample.smoothingPixels = usual.smoothingPixels;
    sample.smoothingLength = usual.smoothingLength;
    sample.imagingTipRadius = usual.imagingTipRadius;
    sample.erode = usual.erode;
    sample.material = usual.material;
    return sample;
}

HeightField fieldFor(const LoadedScene& loaded, const MeasuredScan::Leveled* leveled,
                     bool isSmoothed) {
    if (leveled != nullptr) {
        return std::visit([](const auto& map) { return bilinearField(map); }, *leveled);
    }
    const BSplineSurface& surface = loaded.scene.surface;
    const SampleDescription& sample = loaded.scene.description.sample;
    const bool isExact = sample.shape || (isSmoothed && hasOtherHeights(sample));
    return isExact ? fieldOf(surface) : bilinearField(surface);
}

}  // namespace

MeasuredScan::MeasuredScan(std::shared_ptr<const LoadedScene> loaded,
                           std::shared_ptr<const Leveled> leveled, bool isSmoothed)
    : loaded_(std::move(loaded))
    , leveledScan_(std::move(leveled))
    , field_(fieldFor(*loaded_, leveledScan_.get(), isSmoothed)) {
    const SampleDescription& sample = loaded_->scene.description.sample;
    name_ = sampleName(sample);
    file_ = sample.shape ? name_ : std::filesystem::path(sample.file).filename().string();
    channel_ = sample.channel;
    leveling_ = levelingText(sample);
    smoothing_ = leveledScan_ == nullptr
                     ? smoothingText(sample)
                     : MeasuredHeights::tr("none; the tip meets: %1").arg(smoothingText(sample));
}

HeightRows MeasuredScan::rows() const {
    return leveledScan_ == nullptr
               ? rowsOf(loaded_->scene.surface)
               : std::visit([](const auto& map) { return rowsOf(map); }, *leveledScan_);
}

QString MeasuredScan::calibration() const {
    const Uncertainty& given = loaded_->scene.description.uncertainty;
    return given.enabled ? MeasuredHeights::tr("z ± %1 %, x and y ± %2 %")
                               .arg(100.0 * given.heightCalibration)
                               .arg(100.0 * given.lateralCalibration)
                         : QString();
}

std::vector<std::string> MeasuredScan::provenance(const std::string& what) const {
    std::vector<std::string> lines{std::string("Asperity ") + kVersion + ": " + what + " of " +
                                       name_,
                                   "smoothing of what was measured: " + smoothing_.toStdString()};
    lines.insert(lines.end(), loaded_->notes.begin(), loaded_->notes.end());
    return lines;
}

MeasuredHeights::MeasuredHeights(Stage& stage)
    : Feature(stage)
    , state_(tr("No scan is open"))
    , reading_(
          {.progressed =
               [this](double share) {
                   setState(tr("Reading the scan: %1 %").arg(std::lround(100.0 * share)));
               },
           .finished =
               [this](MeasuredScan::Leveled& leveled) {
                   leveled_ = std::make_shared<const MeasuredScan::Leveled>(std::move(leveled));
                   Q_EMIT changed();
               },
           .failed = [this](const std::exception_ptr& reason) { setState(reasonOf(reason)); }}) {
    for (const auto shown :
         {&RunControl::begun, &RunControl::recordingShown, &RunControl::liveShown}) {
        connect(&runs_, shown, this, &MeasuredHeights::begin);
    }
}

/// Another material or tip leaves the heights as they are.
void MeasuredHeights::begin() {
    const auto loaded = runs_.shared();
    if (leveled_ == nullptr || hash_ != loaded->sha256 ||
        source_ != sourceOf(loaded->scene.description.sample)) {
        reading_.cancel();
        source_.reset();
        leveled_.reset();
    }
}

std::shared_ptr<const MeasuredScan> MeasuredHeights::scan() {
    if (runs_.run() == nullptr) {
        state_ = tr("No scan is open");
        return nullptr;
    }
    const auto loaded = runs_.shared();
    const SampleDescription& sample = loaded->scene.description.sample;
    if (isSmoothed_ || !hasOtherHeights(sample)) {
        return std::make_shared<const MeasuredScan>(loaded, nullptr, isSmoothed_);
    }
    if (leveled_ != nullptr) {
        return std::make_shared<const MeasuredScan>(loaded, leveled_, isSmoothed_);
    }
    if (!source_) {
        source_ = sourceOf(sample);
        hash_ = loaded->sha256;
        state_ = tr("Reading the scan");
        reading_.start(
            [source = *source_](Progress& progress) { return leveledScan(source, &progress); });
    }
    return nullptr;
}

void MeasuredHeights::follow(QCheckBox& smoothed) {
    connect(&smoothed, &QCheckBox::toggled, this, &MeasuredHeights::setSmoothed);
    connect(this, &MeasuredHeights::smoothedChosen, &smoothed, &QCheckBox::setChecked);
    smoothed.setChecked(isSmoothed_);
}

void MeasuredHeights::setSmoothed(bool smoothed) {
    if (isSmoothed_ != smoothed) {
        isSmoothed_ = smoothed;
        if (leveled_ == nullptr) {  // a file that failed is tried again when it is needed
            reading_.cancel();
            source_.reset();
        }
        Q_EMIT smoothedChosen(smoothed);
        Q_EMIT changed();
    }
}

void MeasuredHeights::setState(const QString& words) {
    state_ = words;
    Q_EMIT changed();
}

QCheckBox* newSmoothedBox(const char* name, QWidget* parent) {
    auto* box =
        named(new QCheckBox(MeasuredHeights::tr("Smoothed, as the tip meets it"), parent), name,
              MeasuredHeights::tr("Measures the surface that the tip touches, with the "
                                  "smoothing of the scene, on all pages; off: the leveled "
                                  "heights of the scan"));
    box->setFocusPolicy(Qt::TabFocus);
    return box;
}

}  // namespace asperity
