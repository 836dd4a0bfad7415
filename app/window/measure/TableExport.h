#pragma once

#include <QString>

#include <filesystem>
#include <functional>

namespace asperity {

class Host;

/// Writes a table into a file. @throw Error
using WriteTable = std::function<void(const std::filesystem::path& file)>;

/// Asks for a file and writes a table to it. @param title of the dialog
/// @param name of the file, as the dialog offers it
void askForTable(Host& host, const QString& title, const QString& name, const WriteTable& write);

/// Writes a table; says in the window what came of it.
void writeTableTo(Host& host, const std::filesystem::path& file, const WriteTable& write);

}  // namespace asperity
