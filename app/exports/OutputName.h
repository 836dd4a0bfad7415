#pragma once

#include <filesystem>
#include <string>

namespace asperity {

/// What names of files are made of.
struct OutputNameParts {
    std::string file;  ///< of the input
    std::string view;
};

/// A file in a folder, by a name whose placeholders {file}, {view} and {n} are filled in; n counts
/// from 1 to the first name that is free. A name without {n} may be that of a file that is there.
/// @throw Error for another placeholder
[[nodiscard]] std::filesystem::path namedPath(const std::filesystem::path& folder,
                                              const std::string& name,
                                              const OutputNameParts& parts);

/// The path that --out stands for: placeholders of its last name are filled in as by namedPath();
/// its folders are as they are. @throw Error for another placeholder
[[nodiscard]] std::filesystem::path filledPath(const std::filesystem::path& out,
                                               const OutputNameParts& parts);

/// The file that --out stands for. A folder, or a text that ends in '/': a new file of the name
/// {file}_{view}_{n}.png in it; else as filledPath().
/// @throw Error for another placeholder, and where the file is there and nothing may replace it
/// @param force a file of the name may be replaced
[[nodiscard]] std::filesystem::path outputPath(const std::string& out, const OutputNameParts& parts,
                                               bool force);

}  // namespace asperity
