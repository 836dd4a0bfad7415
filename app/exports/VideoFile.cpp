#include "app/exports/VideoFile.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kLook(20);  // for a cancellation

std::string extensionOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char letter) { return std::tolower(letter); });
    return extension;
}

/// Colors at full range of each frame; sides are even numbers, as the encoders want them.
std::vector<std::string> argumentsFor(const TemporaryFile& file, PictureSize size, double fps) {
    std::vector<std::string> arguments{"ffmpeg",
                                       "-hide_banner",
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
    const bool isWebm = extensionOf(file.target()) == ".webm";
    const std::vector<std::string> encoding =
        isWebm ? std::vector<std::string>{"-c:v",    "libvpx-vp9", "-crf", "24",        "-b:v",
                                          "0",       "-deadline",  "good", "-cpu-used", "4",
                                          "-row-mt", "1",          "-f",   "webm"}
               : std::vector<std::string>{"-c:v",   "libx264",   "-crf",       "18", "-preset",
                                          "medium", "-movflags", "+faststart", "-f", "mp4"};
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

/// Starts a program in a session of its own: Ctrl+C is for ours, which ends it in good order.
/// @return the error; 0: none
int spawn(pid_t& child, std::vector<std::string> arguments, int input, int complaints) {
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
    const int error =
        posix_spawnp(&child, pointers.front(), &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

}  // namespace

bool isVideo(const std::filesystem::path& file) {
    const std::string extension = extensionOf(file);
    return extension == ".mp4" || extension == ".webm";
}

VideoFile::VideoFile(const std::filesystem::path& path, PictureSize size, double fps)
    : file_(path), complaints_(memfd_create("ffmpeg", MFD_CLOEXEC)) {
    start(size, fps);
}

VideoFile::~VideoFile() {
    if (encoder_ > 0) {
        kill(encoder_, SIGKILL);
        while (waitpid(encoder_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
}

void VideoFile::start(PictureSize size, double fps) {
    // No pipe: one that is closed at the other end would end the program by a signal.
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        throw Error(file_.target().string() + ": ffmpeg cannot be started");
    }
    const FileDescriptor input(ends[0]);
    frames_ = FileDescriptor(ends[1]);
    const int error =
        spawn(encoder_, argumentsFor(file_, size, fps), input.get(), complaints_.get());
    if (error != 0) {
        encoder_ = -1;
        throw Error(file_.target().string() +
                    (error == ENOENT ? ": videos are made by the program ffmpeg, which was not "
                                       "found (Debian package ffmpeg); give a folder for single "
                                       "pictures"
                                     : ": ffmpeg cannot be started"));
    }
}

void VideoFile::add(const RasterImage& frame, const Progress* progress) {
    for (std::size_t done = 0; done < frame.pixels.size();) {
        const ssize_t count = send(frames_.get(), frame.pixels.data() + done,
                                   frame.pixels.size() - done, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && errno == EAGAIN) {
            pollfd room{.fd = frames_.get(), .events = POLLOUT, .revents = 0};
            poll(&room, 1, static_cast<int>(kLook.count()));
        } else if (count < 0 && errno != EINTR) {
            fail();
        }
        requireWanted(progress);
        done += count > 0 ? static_cast<std::size_t>(count) : 0U;
    }
}

void VideoFile::commit(const Progress* progress) {
    const int status = end(progress);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        fail();
    }
    file_.commit();
}

/// Waits for the encoder. @return how it ended
int VideoFile::end(const Progress* progress) {
    frames_ = FileDescriptor(-1);
    int status = 0;
    while (waitpid(encoder_, &status, WNOHANG) == 0) {
        requireWanted(progress);
        std::this_thread::sleep_for(kLook);
    }
    encoder_ = -1;
    return status;
}

void VideoFile::fail() {
    if (encoder_ > 0) {
        end(nullptr);
    }
    std::array<char, 400> said{};
    const ssize_t count = pread(complaints_.get(), said.data(), said.size(), 0);
    std::string line(said.data(), count > 0 ? static_cast<std::size_t>(count) : 0U);
    line = line.substr(0, line.find('\n'));
    throw Error(file_.target().string() + ": ffmpeg could not write the video" +
                (line.empty() ? std::string() : ": " + line));
}

}  // namespace asperity
