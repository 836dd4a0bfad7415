#pragma once

#include "core/ProgramRun.h"
#include "core/Progress.h"
#include "core/TemporaryFile.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Returns whether a file's extension is that of a video.
[[nodiscard]] bool isVideo(const std::filesystem::path& file);
/// The extensions of videos.
[[nodiscard]] std::vector<std::string> videoExtensions();
/// The same for people: ".mp4 or .webm".
[[nodiscard]] std::string videoExtensionList();

/// Returns whether ffmpeg is installed; a VideoFile needs it.
[[nodiscard]] bool haveVideoEncoder();

/// A video that the program ffmpeg encodes while its frames are drawn. Whole or not at all: without
/// commit() nothing is left. The thread that makes it must outlive it, see RunningProgram.
class VideoFile {
public:
    /// @param path isVideo() @param fps frames a second
    /// @throw Error when there is no ffmpeg, or the file cannot be written
    VideoFile(const std::filesystem::path& path, PictureSize size, double fps);

    /// @param progress may be null; asked whether to give up while ffmpeg works
    /// @throw Error with what ffmpeg says, when it has ended; Canceled
    void add(const RasterImage& frame, const Progress* progress);
    /// @throw the same
    void commit(const Progress* progress);

private:
    [[nodiscard]] ProgramOutcome ended(const Progress* progress);
    [[noreturn]] void fail(const ProgramOutcome& outcome) const;

    TemporaryFile file_;
    RunningProgram encoder_;
};

}  // namespace asperity
