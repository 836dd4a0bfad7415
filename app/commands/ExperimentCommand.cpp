#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/experiment/OpenStudy.h"
#include "app/experiment/StudyResults.h"
#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "core/experiment/Study.h"
#include "core/io/experiment/StudyFile.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace asperity {

namespace {

struct ExperimentOptions {
    std::string study;
    OperatorRun run;
    int repeats = 0;  // 0: the study's own
    std::string out;
    bool aids = false;
    bool resume = false;
    bool force = false;
};

std::filesystem::path studyFile(const ExperimentOptions& options) {
    if (!options.study.empty()) {
        return options.study;
    }
    const std::filesystem::path data = dataFolder();
    if (data.empty()) {
        throw Error("the program's data folder is missing: name a study");
    }
    return data / "studies" / "positioning.toml";
}

Study studyOf(const ExperimentOptions& options) {
    Study study = readStudy(studyFile(options));
    if (options.repeats > 0) {
        study.repeats = options.repeats;
    }
    return study;
}

FolderUse useOf(const ExperimentOptions& options) {
    return options.resume ? FolderUse::Resume : options.force ? FolderUse::Replace : FolderUse::New;
}

/// @throw InputError for all but the faults that only the study's scenes show
StudyScenes scenesOf(const ExperimentOptions& options, const Study& study) {
    try {
        ProgressLine line("loading");
        return {study, &line};
    } catch (const StudyRefused& refused) {
        throw InputError(studyFile(options).string(), refused.key, "expected " + refused.reason);
    }
}

/// @return what was done
std::vector<TrialRecord> run(const ExperimentOptions& options, const Study& study,
                             const std::filesystem::path& out) {
    const StudyScenes scenes = scenesOf(options, study);
    ExperimentFolder folder(out, study, useOf(options));
    {
        ProgressLine line("trials");
        runOperators(scenes, options.run, folder, &line);
    }
    writeStudyResults(folder);
    writeStudyFigures(folder);
    std::cout << studyText(folder);
    return folder.trials();
}

void runWithAids(const ExperimentOptions& options, const Study& study) {
    std::vector<AidResult> results;
    for (const AidVariant& variant : aidVariants(study)) {
        std::cout << variant.name << ":\n";
        results.push_back({.name = variant.name,
                           .trials = run(options, variant.study,
                                         std::filesystem::path(options.out) / variant.name)});
    }
    writeAids(std::filesystem::path(options.out) / "aids.csv", study, results);
}

void experiment(const ExperimentOptions& options) {
    const OffscreenApplication application;
    const Study study = studyOf(options);
    if (options.aids) {
        runWithAids(options, study);
    } else {
        run(options, study, options.out);
    }
}

}  // namespace

void addExperimentCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "experiment",
        "Run a positioning study with operators of a model: hold the tip above, on and below a "
        "surface");
    const auto options = std::make_shared<ExperimentOptions>();
    command->add_option("STUDY", options->study,
                        "study.toml; default: the study that comes with the program");
    command->add_option("--operators", options->run.operators, "how many operators do the study")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--repeats", options->repeats,
                     "of each task on each material; default: as in the study")
        ->check(CLI::Range(1, 100));
    command->add_option("--seed", options->run.seed, "of operators, orders and noise")
        ->capture_default_str();
    addOutputFolder(*command, options->out, "folder for trials, tables and figures");
    command->add_flag("--aids", options->aids,
                      "repeat the study without coupling, without forces, without the picture of "
                      "the deformation, and with a guide, each in its own folder");
    command->add_flag("--record", options->run.record,
                      "keep every tick of each trial, for asperity replay");
    CLI::Option* const resume = command->add_flag("--resume", options->resume,
                                                  "continue the interrupted study in that folder");
    command->add_flag("--force", options->force, "replace a study in that folder")
        ->excludes(resume);
    command->callback([options] { experiment(*options); });
}

}  // namespace asperity
