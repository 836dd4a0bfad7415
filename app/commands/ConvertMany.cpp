#include "app/commands/ConvertMany.h"

#include "app/commands/ConvertMap.h"
#include "app/commands/ConvertTargets.h"
#include "app/program/ToldError.h"
#include "core/Error.h"
#include "core/PathText.h"
#include "core/PrintableText.h"

#include <iostream>
#include <map>
#include <new>
#include <set>

namespace asperity {

namespace {

/// Refuses before anything is done what no input could be converted with. @throw Error
void makeFolder(const std::string& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder, failure)) {
        throw FileError(folder, "the folder cannot be made");
    }
}

/// A scan is often the only copy of a measurement.
void refuseToOverwriteInputs(const ConvertOptions& options, const ConvertedFile& file) {
    std::vector<std::string> inputs{options.input};
    inputs.insert(inputs.end(), options.others.begin(), options.others.end());
    for (const std::string& input : inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(input, file.output, ignored)) {
            throw Error("its output " + file.output + " is " +
                        (input == file.input ? "the file itself" : "another input") +
                        "; name another folder");
        }
    }
}

void convertOne(const ConvertOptions& options, const ConvertedFile& file) {
    refuseToOverwriteInputs(options, file);
    requireWritableTargets(options, file);
    const Converted converted = options.all ? convertAll(options, file) : convertMap(options, file);
    for (const std::string& note : converted.notes) {
        std::cerr << "note: " << printable(file.input) << ": " << printable(note) << '\n';
    }
    std::cout << printable(file.input) << " -> " << printable(file.output) << ": "
              << printable(converted.summary) << std::endl;  // a line when it is true
}

/// @return whether it worked
bool tryOne(const ConvertOptions& options, const ConvertedFile& file) {
    std::string reason;
    try {
        convertOne(options, file);
        return true;
    } catch (const Canceled&) {
        throw;
    } catch (const std::bad_alloc&) {
        reason = "out of memory";
    } catch (const std::exception& error) {
        reason = messageOf(error);
    }
    const bool namesFile = reason.starts_with(file.input + ":");
    std::cerr << "asperity: " << (namesFile ? "" : printable(file.input) + ": ")
              << printable(reason) << '\n';
    return false;
}

}  // namespace

std::vector<ConvertedFile> filesInFolder(const std::vector<std::string>& inputs,
                                         const std::filesystem::path& folder,
                                         const std::string& extension) {
    std::map<std::string, int> stems;
    for (const std::string& input : inputs) {
        ++stems[std::filesystem::path(input).stem().string()];
    }
    std::set<std::string> taken;
    std::vector<ConvertedFile> files;
    for (const std::string& input : inputs) {
        const std::filesystem::path path(input);
        const std::string stem = path.stem().string();
        const bool isClear = stems[stem] == 1 || path.extension() == extension;
        const std::string base = isClear ? stem : path.filename().string();
        std::string name = base + extension;
        for (int number = 2; !taken.insert(name).second; ++number) {
            name = base + "-" + std::to_string(number) + extension;
        }
        files.push_back({input, (folder / name).string()});
    }
    return files;
}

void convertMany(const ConvertOptions& options) {
    std::vector<std::string> inputs{options.input};
    inputs.insert(inputs.end(), options.others.begin(), options.others.end());
    const std::string extension =
        (options.extension.starts_with('.') ? "" : ".") + options.extension;
    requireTarget(options, "--to", "OUT" + extension);
    makeFolder(options.folder);
    std::size_t failed = 0;
    for (const ConvertedFile& file : filesInFolder(inputs, options.folder, extension)) {
        failed += tryOne(options, file) ? 0 : 1;
    }
    if (failed > 0) {
        throw Error(std::to_string(failed) + " of " + std::to_string(inputs.size()) +
                    " files could not be converted");
    }
}

}  // namespace asperity
