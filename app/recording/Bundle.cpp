#include "app/recording/Bundle.h"

#include "app/program/JsonText.h"
#include "app/recording/RecordedRun.h"
#include "app/runs/RunFolder.h"
#include "core/PrintableText.h"
#include "core/Version.h"
#include "core/io/FileBytes.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/zip/ZipArchive.h"
#include "core/io/zip/ZipWriter.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

namespace {

constexpr const char* kDirectory = "bundle.json";
constexpr const char* kBundleFormat = "asperity bundle";
constexpr int kBundleVersion = 1;
constexpr const char* kPicture = "picture.png";
constexpr std::string_view kScanFolder = "scan/";
constexpr std::uint64_t kMaxDirectory = 1U << 20U;  // [byte]
constexpr std::size_t kMaxName = 255;               // that file systems accept [byte]

struct BundledFile {
    std::string name;            ///< in the bundle
    std::filesystem::path file;  ///< on the disk
    std::string sha256 = {};     ///< that it must have; empty: any
};

/// The own name of a scan, map or curve, where an archive can hold it and has no other file of that
/// name.
std::string scanEntry(const std::filesystem::path& scan, const std::vector<BundledFile>& files) {
    const std::string own = scan.filename().string();
    const std::string name = isUtf8(own) ? own : "scan" + scan.extension().string();
    std::string entry = std::string(kScanFolder) + name;
    for (int next = 2; std::ranges::find(files, entry, &BundledFile::name) != files.end(); ++next) {
        entry = std::string(kScanFolder) + std::to_string(next) + "_" + name;
    }
    return entry;
}

/// Adds a file that the scene is read from; one that is there already is taken once.
/// @return its name in the bundle
std::string addInput(const std::string& file, const std::string& sha256,
                     std::vector<BundledFile>& files) {
    const std::filesystem::path input = file;
    const auto same = std::ranges::find(files, input, &BundledFile::file);
    if (same != files.end()) {
        return same->name;
    }
    files.push_back({scanEntry(input, files), input, sha256});
    return files.back().name;
}

/// The files of a bundle, but for its directory. The scene, which names another path of the scan,
/// is written into `folder`.
std::vector<BundledFile> filesOf(const std::filesystem::path& run,
                                 const std::filesystem::path& picture,
                                 const std::filesystem::path& folder) {
    std::vector<BundledFile> files;
    for (const std::string& name : runFileNames()) {
        if (name != run_files::kScene && isThere(run / name)) {
            files.push_back({name, run / name});
        }
    }
    SceneDescription scene = readRecordedScene(run / run_files::kScene);
    if (!scene.sample.shape) {
        scene.sample.file = addInput(scene.sample.file, scanRecord(run).sha256, files);
    }
    for (MaterialSources* maps : {&scene.sample.material.maps, &scene.truth.material.maps}) {
        forEachSource(*maps, [&files](MapSource& source) {
            source.file = addInput(source.file, source.sha256, files);
        });
    }
    if (!scene.truth.curve.empty()) {
        scene.truth.curve = addInput(scene.truth.curve, {}, files);
    }
    writeTextFile(folder / run_files::kScene, sceneText(scene));
    files.push_back({run_files::kScene, folder / run_files::kScene});
    if (!picture.empty()) {
        files.push_back({kPicture, picture});
    }
    return files;
}

nlohmann::ordered_json directoryOf(const std::vector<BundledFile>& files, Progress* progress) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const double share = 1.0 / static_cast<double>(files.size());
        ProgressPart part(progress, static_cast<double>(i) * share,
                          static_cast<double>(i + 1) * share);
        const FileBytes bytes(files[i].file);
        list.push_back(
            {{"name", files[i].name}, {"bytes", bytes.size()}, {"sha256", sha256Of(bytes, &part)}});
    }
    return {{"format", kBundleFormat},
            {"format_version", kBundleVersion},
            {"versions", {{"asperity", kVersion}, {"compiler", __VERSION__}}},
            {"files", list}};
}

/// @throw InputError where a scan or map in a bundle is not the one that the run was made on
void requireOwnScans(const nlohmann::ordered_json& directory,
                     const std::vector<BundledFile>& files) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string& wanted = files[i].sha256;
        if (!wanted.empty() && directory.at("files").at(i).at("sha256") != wanted) {
            throw InputError(files[i].file.string(), "",
                             "this file has changed since the run was recorded (its hash differs)");
        }
    }
}

/// A name that a bundle of ours gives a file: none leads out of its folder.
bool isKnown(const std::string& name) {
    if (name.starts_with(kScanFolder)) {
        const std::string scan = name.substr(kScanFolder.size());
        return !scan.empty() && scan.size() <= kMaxName && scan != "." && scan != ".." &&
               scan.find_first_of(std::string_view("/\\\0", 3)) == std::string::npos;
    }
    const std::vector<std::string>& names = runFileNames();
    return name == kPicture || std::ranges::find(names, name) != names.end();
}

/// A bundle's entry on one of its files.
struct ListedFile {
    std::string name;
    std::uint64_t bytes = 0;
    std::string sha256;
};

/// @throw InputError where a name is not one that a bundle of ours gives, or comes twice
void requireOwnNames(const std::vector<ListedFile>& files, const std::string& bundle) {
    std::set<std::string> names;
    for (const ListedFile& one : files) {
        if (!isKnown(one.name)) {
            throw InputError(bundle, kDirectory, "'" + one.name + "' is no file of a run");
        }
        if (!names.insert(one.name).second) {
            throw InputError(bundle, kDirectory, "'" + one.name + "' is listed twice");
        }
    }
}

/// Recordings of a tip at rest shrink to a fortieth. @throw InputError where a bundle promises far
/// more than it can hold
void requirePlausibleSize(const std::vector<ListedFile>& files, const ByteSource& bundle) {
    constexpr std::uint64_t kMaxExpansion = 200;
    constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{1} << 29U;  // a flat scan shrinks more
    const std::uint64_t most = std::max(bundle.size() * kMaxExpansion, kAlwaysAllowed);
    std::uint64_t left = most;
    for (const ListedFile& one : files) {
        if (one.bytes > left) {
            throw InputError(bundle.name(), one.name,
                             "the files up to this one have more than " + std::to_string(most) +
                                 " bytes; a bundle of " + std::to_string(bundle.size()) +
                                 " bytes is not expected to hold as many");
        }
        left -= one.bytes;
    }
}

std::vector<ListedFile> listed(const ZipArchive& archive, const std::string& file) {
    const ZipEntry* const entry = archive.find(kDirectory);
    if (entry == nullptr) {
        throw InputError(file, "", "expected a bundle: there is no bundle.json in it");
    }
    const nlohmann::json json =
        parsedJson(archive.decoded(*entry, kMaxDirectory), file + ": " + kDirectory);
    std::vector<ListedFile> files;
    try {
        if (json.at("format") != kBundleFormat || json.at("format_version") != kBundleVersion) {
            throw InputError(file, kDirectory, "expected a bundle, format version 1");
        }
        for (const auto& one : json.at("files")) {
            // A number of another kind would be converted, whatever it is.
            if (!one.at("bytes").is_number_unsigned()) {
                throw InputError(file, kDirectory, "expected a whole number of bytes of each file");
            }
            files.push_back({one.at("name"), one.at("bytes"), one.at("sha256")});
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(file, kDirectory, "expected format, format_version and files of a bundle");
    }
    requireOwnNames(files, file);
    return files;
}

/// Writes a file of a bundle into the folder, where it is as the bundle says.
void unpack(const ZipArchive& archive, const ListedFile& file, const std::string& bundle,
            const std::filesystem::path& folder) {
    const ZipEntry* const entry = archive.find(file.name);
    if (entry == nullptr) {
        throw InputError(bundle, file.name, "this file is missing in the bundle");
    }
    const std::filesystem::path target = folder / file.name;
    std::filesystem::create_directories(target.parent_path());
    OutputFile out(target);
    Sha256 hash;
    archive.decode(*entry, file.bytes, [&](std::span<const char> piece) {
        hash.add(piece);
        out.stream().write(piece.data(), static_cast<std::streamsize>(piece.size()));
    });
    if (hash.digits() != file.sha256) {
        throw InputError(bundle, file.name,
                         "this file is damaged (its hash is not that in bundle.json)");
    }
    out.commit();
}

bool isZip(const FileBytes& bytes) {
    constexpr std::array<char, 4> kZip{'P', 'K', 3, 4};
    std::array<char, 4> start{};
    if (bytes.size() < start.size()) {
        return false;
    }
    bytes.read(0, start);
    return start == kZip;
}

std::string replacedAll(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); at != std::string::npos;
         at = text.find(part, at + by.size())) {
        text.replace(at, part.size(), by);
    }
    return text;
}

}  // namespace

void writeBundle(const std::filesystem::path& run, const std::filesystem::path& picture,
                 const std::filesystem::path& bundle, Progress* progress) {
    const PrivateFolder folder;
    std::vector<BundledFile> files = filesOf(run, picture, folder.path());
    ProgressPart hashing(progress, 0.0, 0.4);
    const nlohmann::ordered_json directory = directoryOf(files, &hashing);
    requireOwnScans(directory, files);
    writeTextFile(folder.path() / kDirectory, jsonText(directory) + "\n");
    files.insert(files.begin(), {kDirectory, folder.path() / kDirectory});
    ZipWriter zip(bundle);
    for (const BundledFile& file : files) {
        zip.addFile(file.name, file.file);
    }
    ProgressPart packing(progress, 0.4, 1.0);
    zip.close(&packing);
}

bool isBundle(const std::filesystem::path& file) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(file, unknown)) {
        return false;
    }
    try {
        const FileBytes bytes(file);
        return isZip(bytes) && ZipArchive(bytes).find(kDirectory) != nullptr;
    } catch (const InputError&) {
        return false;
    }
}

void unpackBundle(const std::filesystem::path& bundle, const std::filesystem::path& folder,
                  Progress* progress) {
    const FileBytes bytes(bundle);
    if (!isZip(bytes)) {
        throw InputError(bundle.string(), "", "expected the folder of a run, or a bundle");
    }
    const ZipArchive archive(bytes);
    const std::vector<ListedFile> files = listed(archive, bundle.string());
    requirePlausibleSize(files, bytes);
    double done = 0.0;
    for (const ListedFile& file : files) {
        reportTo(progress, done / static_cast<double>(files.size()));
        done += 1.0;
        unpack(archive, file, bundle.string(), folder);
    }
    reportTo(progress, 1.0);
}

std::filesystem::path keptBundle(const std::filesystem::path& bundle,
                                 const std::filesystem::path& parent, Progress* progress) {
    constexpr std::size_t kDigits = 12;  // of the hash
    ProgressPart hashing(progress, 0.0, 0.2);
    const std::string hash = sha256Of(FileBytes(bundle), &hashing);
    std::filesystem::path folder =
        parent / (bundle.stem().string() + "_" + hash.substr(0, kDigits));
    const std::filesystem::path mark = folder / kDirectory;  // written last: it is whole
    if (!isThere(mark)) {
        std::filesystem::create_directories(folder);
        ProgressPart unpacking(progress, 0.2, 1.0);
        unpackBundle(bundle, folder, &unpacking);
        const FileBytes bytes(bundle);
        const ZipArchive archive(bytes);
        writeTextFile(mark, archive.decoded(*archive.find(kDirectory), kMaxDirectory));
    }
    return folder;
}

RunLocation::RunLocation(const std::filesystem::path& input) : input_(input), folder_(input) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(input, unknown)) {
        unpacked_.emplace();
        folder_ = unpacked_->path();
        unpackBundle(input, folder_);
    } else if (!std::filesystem::is_directory(input, unknown)) {
        throw InputError(input.string(), "", "expected the folder of a run, or a bundle");
    }
}

void throwAsPartOf(const std::filesystem::path& bundle, const std::filesystem::path& folder,
                   const FileError& refusal) {
    const std::string text = refusal.what();
    const std::string path = printable(folder.string());
    if (text.find(path) == std::string::npos) {
        throw;
    }
    const std::string name = printable(bundle.string());
    const std::string named = replacedAll(replacedAll(text, path + "/", name + ", "), path, name);
    constexpr std::string_view kAfterFile = ": ";
    const std::size_t end = named.find(kAfterFile);
    throw InputError(named.substr(0, end), "", named.substr(end + kAfterFile.size()));
}

std::filesystem::path runOf(const std::filesystem::path& file) {
    const std::vector<std::string>& names = runFileNames();
    return std::ranges::find(names, file.filename().string()) == names.end() ? file
                                                                             : file.parent_path();
}

}  // namespace asperity
