#pragma once

#include <string>
#include <vector>

namespace asperity::test {

/// The files of ../shared/data/afm that are read natively, relative to that folder.
[[nodiscard]] const std::vector<std::string>& realScans();

/// A file name that can be part of a test's name.
[[nodiscard]] std::string testName(const std::string& file);

}  // namespace asperity::test
