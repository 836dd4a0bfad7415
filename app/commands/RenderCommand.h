#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity render`: draws a scene, or a moment of a run, as a picture, a plot, or a field.
void addRenderCommand(CLI::App& program);

}  // namespace asperity
