#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// `asperity devices`: lists the input devices here and what each can do, for people or as JSON.
void addDevicesCommand(CLI::App& program);

}  // namespace asperity
