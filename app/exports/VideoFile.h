#pragma once

#include "core/FileDescriptor.h"
#include "core/Progress.h"
#include "core/TemporaryFile.h"
#include "vtkplugins/pictures/PictureSize.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>
#include <string>
#include <sys/types.h>

namespace asperity {

/// Whether a file's extension is that of a video: .mp4, .webm.
[[nodiscard]] bool isVideo(const std::filesystem::path& file);

/// A video that the program ffmpeg encodes while its frames are drawn. Whole or not at all.
class VideoFile {
public:
    /// @param fps frames a second
    /// @throw Error when there is no ffmpeg, or the file cannot be written
    VideoFile(const std::filesystem::path& path, PictureSize size, double fps);
    /// Without commit() nothing is left.
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    /// @param progress may be null; asked whether to give up while ffmpeg takes its time
    /// @throw Error with what ffmpeg says, when it has ended; Canceled
    void add(const RasterImage& frame, const Progress* progress);
    /// @throw likewise
    void commit(const Progress* progress);

private:
    void start(PictureSize size, double fps);
    [[noreturn]] void fail();
    int end(const Progress* progress);

    TemporaryFile file_;
    FileDescriptor complaints_;  ///< what ffmpeg says
    FileDescriptor frames_{-1};
    pid_t encoder_ = -1;
};

}  // namespace asperity
