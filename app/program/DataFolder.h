#pragma once

#include "core/TemporaryFile.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The folder `data` that belongs to this program: what ASPERITY_DATA names, else the nearest one
/// above the program itself. Empty when there is none.
[[nodiscard]] std::filesystem::path dataFolder();

/// The files of a kind ("materials", "scenes") in the data folder, by name.
[[nodiscard]] std::vector<std::filesystem::path> dataFiles(const std::filesystem::path& kind);

/// The scene of commands that are given none; empty when there is none.
[[nodiscard]] std::filesystem::path defaultSceneFile();

/// The scene with which the window begins, a soft and sticky sample; empty when there is none.
[[nodiscard]] std::filesystem::path firstSceneFile();

/// The folder of a desktop session that Qt asks for, XDG_RUNTIME_DIR, for as long as this lives:
/// where there is none, Qt would make one in TMPDIR and leave it there. It is made before the
/// application and outlives it, on the main thread while no other one reads the environment.
class RuntimeFolder {
public:
    RuntimeFolder();
    RuntimeFolder(const RuntimeFolder&) = delete;
    RuntimeFolder& operator=(const RuntimeFolder&) = delete;
    ~RuntimeFolder();

private:
    std::optional<PrivateFolder> own_;
};

/// Files of one kind, "materials" or "probes": those that come with the program, which stay as they
/// are, and a user's own in a folder of theirs.
class UserLibrary {
public:
    /// @param kind the folder in the data that belong to the program
    explicit UserLibrary(std::string kind) : kind_(std::move(kind)) {}

    /// Sets the folder of the user's own; it is made when the first is saved.
    void setFolder(const std::filesystem::path& folder) { folder_ = folder; }

    struct Entry {
        std::filesystem::path file;
        bool own = false;
    };
    /// Returns the entries: the program's by name, then the user's own.
    [[nodiscard]] std::vector<Entry> entries() const;

    /// The file of the user's own that one of this name would replace; empty: none.
    [[nodiscard]] std::filesystem::path replacedBy(const std::string& name) const;
    /// Writes a file of the user's own; one of the same name is replaced. Complete or not at all.
    /// @param name for people; the file's comes from it
    /// @return the file
    /// @throw Error where that is no name, or one that comes with the program has it
    // NOLINTNEXTLINE(modernize-use-nodiscard): it is called for what it writes
    std::filesystem::path save(const std::string& name, const std::string& text) const;
    /// @throw Error where it comes with the program, or cannot be removed
    void remove(const Entry& entry) const;

private:
    std::string kind_;
    std::filesystem::path folder_;
};

/// The name of a file for something that people call so: "Silicon oxide" is "silicon_oxide". Empty:
/// there is no letter and no digit in it.
[[nodiscard]] std::string fileNameFor(const std::string& name);

}  // namespace asperity
