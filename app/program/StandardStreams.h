#pragma once

namespace asperity {

/// Opens what the program was started without of standard input, output and error (`<&- >&- 2>&-`),
/// so that no file or pipe opened later takes such a place and is read or written by mistake. To
/// read or write them is an error still: nothing that a user asked for is lost unnoticed. Called
/// before anything else opens a file.
void openClosedStandardStreams();

}  // namespace asperity
