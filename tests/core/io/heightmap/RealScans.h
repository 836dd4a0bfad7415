#pragma once

#include <string>
#include <vector>

namespace asperity::test {

/// The files of ../shared/data/afm that are read natively, relative to that folder.
[[nodiscard]] const std::vector<std::string>& realScans();

/// What a channel is called. @param title that Gwyddion gives it: none where the channel has no
/// label, though the wave that it is in has a name
[[nodiscard]] std::string channelName(const std::string& file, const std::string& title);

/// A file name that can be part of a test's name.
[[nodiscard]] std::string testName(const std::string& file);

}  // namespace asperity::test
