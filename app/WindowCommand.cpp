#include "app/WindowCommand.h"

#include "app/DataFolder.h"
#include "app/LiveWindow.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

namespace asperity {

namespace {

/// A bare word that is no file is more likely a command with a slip than a scan.
CLI::Validator noMistypedCommand() {
    return {[](const std::string& text) {
                std::error_code ignored;
                const bool word = text.find_first_of("./") == std::string::npos;
                return word && !std::filesystem::exists(text, ignored)
                           ? text + " is neither a command nor a file"
                           : std::string();
            },
            ""};
}

}  // namespace

std::shared_ptr<WindowOptions> addWindowOptions(CLI::App& program) {
    auto options = std::make_shared<WindowOptions>();
    program
        .add_option("INPUT", options->input,
                    "height map or scene.toml to open in the window; without one, the scene that "
                    "comes with the program")
        ->check(noMistypedCommand());
    return options;
}

int openWindow(const WindowOptions& options) {
    LiveWindow live;
    const std::filesystem::path input =
        options.input.empty() ? defaultSceneFile() : std::filesystem::path(options.input);
    if (!input.empty()) {
        live.session().use(loadScene(input, {}));
    }
    return live.exec();
}

}  // namespace asperity
