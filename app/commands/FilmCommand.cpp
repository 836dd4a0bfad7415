#include "app/commands/FilmCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/PictureOptions.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/exports/ExportInput.h"
#include "app/exports/Film.h"
#include "app/exports/OutputName.h"
#include "app/exports/VideoFile.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <vector>

namespace asperity {

namespace {

struct FilmOptions {
    std::string run;
    std::string out;
    std::string from = keyOf(NamedMoment::Start);
    std::string to = keyOf(NamedMoment::End);
    double fps = 25.0;
    double speed = 1.0;
    double duration = 0.0;  ///< 0: as the speed says [s]
    bool force = false;
    PictureOptions picture;
};

FilmRequest requestOf(const FilmOptions& options) {
    FilmRequest request{.view = viewOf(options.picture),
                        .from = runMoment(options.from),
                        .to = runMoment(options.to),
                        .fps = options.fps,
                        .speed = options.speed,
                        .spec = specOf(options.picture)};
    if (options.duration > 0.0) {
        request.duration = options.duration;
    }
    return request;
}

std::filesystem::path outOf(const FilmOptions& options, const FilmRequest& request) {
    return filledPath(options.out, {.file = exportName(options.run), .view = keyOf(request.view)});
}

void requireUsable(const FilmOptions& options, const std::filesystem::path& out) {
    if (!holdsRun(options.run)) {
        throw InputError(options.run, "",
                         "is no folder of a run: a film needs one that explore or a recording "
                         "wrote, or a bundle of it");
    }
    if (isVideo(out)) {
        requireFree(out, options.force);
    } else if (out.has_extension() && !std::filesystem::is_directory(out)) {
        throw Error(out.string() + ": a film is a folder of pictures, or a video " +
                    videoExtensionList());
    }
}

void film(const FilmOptions& options) {
    const CancelOnSignal cancel;
    const FilmRequest request = requestOf(options);
    const std::filesystem::path out = outOf(options, request);
    requireUsable(options, out);
    const VirtualDisplay display;
    ExportInput input = [&] {
        ProgressLine line("loading");
        return ExportInput(options.run, &line);
    }();
    if (!input.note().empty()) {
        std::cerr << "note: " << input.note() << '\n';
    }
    std::vector<std::size_t> ticks;
    {
        ProgressLine line("drawing");
        ProgressPart finding(&line, 0.0, 0.1);
        ticks = filmTicks(*input.run(), request, &finding);
        ProgressPart drawing(&line, 0.1, 1.0);
        const std::unique_ptr<FilmArtist> artist =
            filmArtist(input.scene(), spatialLook(request.view, request.spec));
        const FilmWork film{*input.run(), *artist, ticks};
        isVideo(out) ? writeVideo(film, request, out, &drawing)
                     : writeFrames(film, request, out, options.force, &drawing);
    }
    std::cout << ticks.size() << " frames in " << printable(out.string()) << '\n';
}

}  // namespace

void addFilmCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand("film", "Draw a run as a film");
    const auto options = std::make_shared<FilmOptions>();
    command
        ->add_option("RUN", options->run,
                     "folder that explore or a recording wrote, or a bundle of one")
        ->required();
    command
        ->add_option(
            "--out", options->out,
            "folder for frame_00001.png ... and frames.csv, or a video " + videoExtensionList() +
                " (by the program ffmpeg); {file}, {view} and {n} of its name are filled in")
        ->required()
        ->check(notEmpty());
    command
        ->add_option("--from", options->from,
                     "first moment: seconds of the run, or " + keyList<NamedMoment>())
        ->capture_default_str()
        ->check(acceptedBy(runMoment));
    command->add_option("--to", options->to, "last moment, likewise")
        ->capture_default_str()
        ->check(acceptedBy(runMoment));
    command->add_option("--fps", options->fps, "frames a second")
        ->check(CLI::Range(1.0, 240.0))
        ->check(finiteNumber())
        ->capture_default_str();
    auto* speed =
        command->add_option("--speed", options->speed, "seconds of the run per second of the film")
            ->check(positiveNumber())
            ->capture_default_str();
    command
        ->add_option("--duration", options->duration, "length of the film [s]; it picks the speed")
        ->check(positiveNumber())
        ->excludes(speed);
    addPictureOptions(*command, options->picture);
    command->add_flag("--force", options->force, "replace an earlier film");
    command->callback([options] { film(*options); });
}

}  // namespace asperity
