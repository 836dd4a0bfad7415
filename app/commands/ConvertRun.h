#pragma once

#include "app/runs/RunFormat.h"

#include <string>

namespace asperity {

/// Writes a run into another folder, with its tables in another format. From the compact format to
/// text, the scan must be where its scene says: the log's last digits are made anew.
/// @param force a run that is there may go
/// @throw Error, InputError
void convertRun(const std::string& run, const std::string& out, RunFormat format, bool force);

}  // namespace asperity
