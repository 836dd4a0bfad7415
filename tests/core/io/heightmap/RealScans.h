#pragma once

#include <string>
#include <vector>

namespace asperity::test {

/// A file that is no height map, or a damaged one.
struct MalformedScan {
    std::string file;      ///< relative to ../shared/data/afm
    std::string location;  ///< in the file, as the refusal says it
    std::string reason;    ///< in the words of the refusal
};

/// The files of ../shared/data/afm that are read natively, relative to that folder.
[[nodiscard]] const std::vector<std::string>& realScans();
/// Files that must be refused.
[[nodiscard]] const std::vector<MalformedScan>& malformedScans();
/// Both, the names alone.
[[nodiscard]] std::vector<std::string> allScans();

/// Our name of a channel, where that is not its title in the tables: a PNG without texts has none,
/// that of the EXR is an attribute, not the name of its plane of samples, and a wave whose channel
/// has no label has a name.
[[nodiscard]] std::string channelName(const std::string& file, const std::string& title);

/// A file name that can be part of a test's name.
[[nodiscard]] std::string testName(const std::string& file);

}  // namespace asperity::test
