#include "app/exports/VideoFile.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <optional>
#include <span>

namespace asperity {

namespace {

constexpr const char* kEncoder = "ffmpeg";

/// A format of videos, and how ffmpeg encodes it.
struct VideoFormat {
    const char* extension;
    std::vector<std::string> encoding;
};

const std::vector<VideoFormat>& videoFormats() {
    static const std::vector<VideoFormat> formats{
        {".mp4",
         {"-c:v", "libx264", "-crf", "18", "-preset", "medium", "-movflags", "+faststart", "-f",
          "mp4"}},
        {".webm",
         {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "4",
          "-row-mt", "1", "-f", "webm"}}};
    return formats;
}

/// Returns the format of a file's extension; null: none.
const VideoFormat* videoFormat(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    const auto found = std::ranges::find(videoFormats(), extension, &VideoFormat::extension);
    return found == videoFormats().end() ? nullptr : &*found;
}

/// Colors at full range of each frame; sides are even numbers, as the encoders want them.
std::vector<std::string> argumentsFor(const TemporaryFile& file, PictureSize size, double fps) {
    std::vector<std::string> arguments{"-hide_banner",
                                       "-loglevel",
                                       "error",
                                       "-nostdin",
                                       "-y",
                                       "-f",
                                       "rawvideo",
                                       "-pix_fmt",
                                       "rgba",
                                       "-video_size",
                                       std::to_string(size.width) + "x" +
                                           std::to_string(size.height),
                                       "-framerate",
                                       exactText(fps),
                                       "-i",
                                       "pipe:0",
                                       "-an",
                                       "-vf",
                                       "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,format=yuv420p"};
    const std::vector<std::string>& encoding = videoFormat(file.target())->encoding;
    arguments.insert(arguments.end(), encoding.begin(), encoding.end());
    arguments.push_back("file:" + file.path().string());
    return arguments;
}

/// @throw Canceled
void requireWanted(const Progress* progress) {
    if (progress != nullptr && progress->isCanceled()) {
        throw Canceled();
    }
}

/// @throw Error when it is not installed
ProgramCall encoderCall(const TemporaryFile& file, PictureSize size, double fps) {
    const std::filesystem::path program = findProgram(kEncoder);
    if (program.empty()) {
        throw Error(file.target().string() +
                    ": videos are made by the program ffmpeg, which was not found (Debian package "
                    "ffmpeg); give a folder for single pictures");
    }
    ProgramCall call = trustedCall(program, argumentsFor(file, size, fps));
    call.isFed = true;
    call.output = ProgramStream::Dropped;
    return call;
}

}  // namespace

bool isVideo(const std::filesystem::path& file) { return videoFormat(file) != nullptr; }

std::vector<std::string> videoExtensions() {
    std::vector<std::string> extensions;
    for (const VideoFormat& format : videoFormats()) {
        extensions.emplace_back(format.extension);
    }
    return extensions;
}

std::string videoExtensionList() {
    std::string list;
    for (const VideoFormat& format : videoFormats()) {
        list.append(list.empty() ? "" : " or ").append(format.extension);
    }
    return list;
}

bool haveVideoEncoder() { return !findProgram(kEncoder).empty(); }

VideoFile::VideoFile(const std::filesystem::path& path, PictureSize size, double fps)
    : file_(path), encoder_(encoderCall(file_, size, fps)) {}

void VideoFile::add(const RasterImage& frame, const Progress* progress) {
    for (std::span<const std::uint8_t> left(frame.pixels); !left.empty();) {
        const std::optional<std::size_t> taken = encoder_.feed(left);
        if (!taken) {
            fail(ended(progress));
        }
        requireWanted(progress);
        left = left.subspan(*taken);
    }
}

void VideoFile::commit(const Progress* progress) {
    const ProgramOutcome outcome = ended(progress);
    if (outcome.end != ProgramEnd::Exited || outcome.exitCode != 0) {
        fail(outcome);
    }
    file_.commit();
}

/// Waits for the encoder.
ProgramOutcome VideoFile::ended(const Progress* progress) {
    encoder_.endInput();
    std::optional<ProgramOutcome> outcome = encoder_.look();
    while (!outcome) {
        requireWanted(progress);
        outcome = encoder_.look();
    }
    return *outcome;
}

void VideoFile::fail(const ProgramOutcome& outcome) const {
    constexpr std::size_t kMaxQuote = 400;
    const std::string line =
        outcome.output.substr(0, std::min(outcome.output.find('\n'), kMaxQuote));
    throw Error(file_.target().string() + ": ffmpeg could not write the video" +
                (line.empty() ? std::string() : ": " + line));
}

}  // namespace asperity
