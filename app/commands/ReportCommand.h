#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity report`: a page of recorded runs each, as HTML and as PDF.
void addReportCommand(CLI::App& program);

}  // namespace asperity
