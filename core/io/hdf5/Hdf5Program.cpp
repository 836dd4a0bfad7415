#include "core/io/hdf5/Hdf5Program.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/ProgramRun.h"
#include "core/TemporaryFile.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kProgram = "asperity_hdf5_reader";
constexpr int kRefused = 3;  // that it exits with, having said why
constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
/// A chunk of 256 MiB, what it is decompressed from, and the libraries.
constexpr std::uint64_t kMaxMemory = 1024 * kMiB;
constexpr std::uint64_t kMinContent = 64 * kMiB;  // paths and shapes
constexpr std::uint64_t kSlowest = kMiB;          // of a file that it reads in a second
/// The program gets at least this share of a processor, whatever else the machine does.
constexpr int kMinShare = 10;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif
#else
constexpr bool kIsSanitized = false;
#endif

std::string environmentValue(const char* name) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing changes the environment after the start
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::optional<std::filesystem::path> programIn(const std::filesystem::path& folder) {
    for (const std::filesystem::path& root : {folder, folder.parent_path() / "libexec/asperity"}) {
        if (isProgram(root / kProgram)) {
            return root / kProgram;
        }
    }
    return std::nullopt;
}

class Hdf5Reading {
public:
    Hdf5Reading(const ByteSource& file, const std::vector<std::string>& paths,
                std::filesystem::path program)
        : file_(file)
        , program_(std::move(program))
        , time_(std::chrono::seconds(10 + file.size() / kSlowest))
        , arguments_{(folder_.path() / "file").string(), (folder_.path() / "content").string()} {
        arguments_.insert(arguments_.end(), paths.begin(), paths.end());
    }

    /// The content stays open, and has no name any more when the folder is removed.
    Hdf5Content read() {
        copyFile();
        const ProgramOutcome outcome = run();
        if (outcome.end == ProgramEnd::TimedOut) {
            fail("the program that reads HDF5 did not end within " + std::to_string(time_.count()) +
                 " s of processor time, or " + std::to_string(kMinShare * time_.count()) +
                 " s in all");
        }
        if (outcome.end == ProgramEnd::Exited && outcome.exitCode == kRefused) {
            fail(std::string(trimmed(outcome.output)));
        }
        if (outcome.end != ProgramEnd::Exited || outcome.exitCode != 0) {
            fail("the program that reads HDF5 crashed on it, or needed more than " +
                 std::to_string(kMaxMemory / kMiB) + " MiB of memory");
        }
        return {std::make_shared<FileBytes>(arguments_[1], file_.name()), file_.name()};
    }

private:
    void copyFile() const {
        try {
            copyTo(file_, arguments_[0]);
        } catch (const FileError&) {
            throw;
        } catch (const Error& error) {  // it names the copy
            const std::string hidden = printable(arguments_[0]);
            std::string message = error.what();
            const std::size_t at = message.find(hidden);
            if (at != std::string::npos) {
                message.replace(at, hidden.size(), folder_.path().parent_path().string());
            }
            throw Error(message);
        }
    }

    [[nodiscard]] ProgramOutcome run() const {
        // A sanitizer needs addresses for all memory that there might be, and has a limit itself.
        const std::string limit =
            ":hard_rss_limit_mb=" + std::to_string(kMaxMemory / kMiB) + ":detect_leaks=0";
        return runProgram(
            {.program = program_,
             .arguments = arguments_,
             .environment = {"LC_ALL=C.UTF-8", "HDF5_USE_FILE_LOCKING=FALSE",
                             "ASAN_OPTIONS=" + limit, "TSAN_OPTIONS=" + limit},
             .folder = folder_.path(),
             .deadline = std::chrono::steady_clock::now() + kMinShare * time_,
             .maxProcessorTime = time_,
             .maxFile = kMinContent + file_.size() * kMaxHdf5Expansion,
             .maxMemory = kIsSanitized ? std::numeric_limits<std::uint64_t>::max() : kMaxMemory});
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw InputError(file_.name(), "", "it cannot be read: " + why);
    }

    const ByteSource& file_;
    std::filesystem::path program_;
    std::chrono::seconds time_;
    PrivateFolder folder_;
    std::vector<std::string> arguments_;
};

constexpr std::string_view kMark = "Asperity, HDF5 behind this block";
constexpr std::string_view kHdf5 = "\x89HDF";          // how a file without a block begins
constexpr std::size_t kPiece = std::size_t{1} << 18U;  // [byte]

std::string sealOf(const ByteSource& file) {
    boost::crc_32_type crc;
    std::vector<char> piece;
    for (std::uint64_t offset = kSealBytes; offset < file.size(); offset += piece.size()) {
        piece.resize(
            static_cast<std::size_t>(std::min<std::uint64_t>(kPiece, file.size() - offset)));
        file.read(offset, piece);
        crc.process_bytes(piece.data(), piece.size());
    }
    std::string seal = std::string(kMark) + formatted(": %llu bytes, CRC-32 %08x\n",
                                                      static_cast<unsigned long long>(file.size()),
                                                      crc.checksum());
    seal.resize(kSealBytes, '\0');
    return seal;
}

}  // namespace

std::filesystem::path hdf5Reader(std::string_view folders) {
    if (const std::string named = environmentValue("ASPERITY_HDF5_READER"); !named.empty()) {
        return named;
    }
    std::error_code unknown;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
    if (const auto found = programIn(self.parent_path())) {
        return *found;
    }
    while (!folders.empty()) {
        const std::filesystem::path folder = folders.substr(0, folders.find(':'));
        // An entry that is not absolute would depend on the folder that the user is in.
        if (const auto found = programIn(folder); found && folder.is_absolute()) {
            return *found;
        }
        folders.remove_prefix(std::min(folder.native().size() + 1, folders.size()));
    }
    return {};
}

Hdf5Content readHdf5(const ByteSource& file, const std::vector<std::string>& paths) {
    const std::filesystem::path program = hdf5Reader(environmentValue("PATH"));
    if (program.empty()) {
        throw Error(std::string("the program ") + kProgram +
                    ", which reads HDF5 files, is not installed beside this one");
    }
    try {
        return Hdf5Reading(file, paths, program).read();
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {  // of the folder, the copy or the program, not of the file
        throw InputError(file.name(), "", std::string("it cannot be read: ") + error.what());
    }
}

void sealHdf5(const std::filesystem::path& path) {
    const std::string seal = sealOf(FileBytes(path));
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.write(seal.data(), static_cast<std::streamsize>(seal.size()));
    file.close();
    if (!file) {
        throw Error(path.string() + ": not all of it could be written");
    }
}

void requireSeal(const ByteSource& file) {
    if (!file.startsWith(kMark)) {
        throw InputError(file.name(), "",
                         file.startsWith(kHdf5)
                             ? "expected a recording in the HDF5 format: this file is another "
                               "program's, it has no check sum of Asperity's"
                             : "expected a file in the HDF5 format");
    }
    if (!file.startsWith(sealOf(file))) {
        throw InputError(file.name(), "",
                         "it is damaged, or another program has changed it: its check sum differs");
    }
}

}  // namespace asperity
