#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity film`: draws a run as a film.
void addFilmCommand(CLI::App& program);

}  // namespace asperity
