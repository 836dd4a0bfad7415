#include "core/Error.h"
#include "core/ProgramRun.h"
#include "core/TemporaryFile.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/GwyddionScan.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/UnreadFormats.h"
#include "core/io/heightmap/gwyddion/Identification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>

// Everything that no format here reads, through the program Gwyddion; docs/formats.md 20.

namespace asperity {

namespace {

constexpr const char* kProgram = "gwyddion";
constexpr std::size_t kMaxName = 100;
constexpr std::size_t kMaxQuote = 300;

/// The end of a file's name, which Gwyddion looks at, too; in plain letters, as an argument.
std::string plainName(const std::string& file) {
    std::string name = std::filesystem::path(file).filename().string();
    name.erase(0, name.size() - std::min(name.size(), kMaxName));
    std::ranges::replace_if(
        name,
        [](char c) {
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                               (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
            return !plain;
        },
        '_');
    return name;
}

void makeFolder(const std::filesystem::path& path) {
    std::error_code failure;
    std::filesystem::create_directory(path, failure);
    if (failure) {
        throw Error(path.string() + ": the folder cannot be made: " + failure.message());
    }
}

/// Gwyddion gives 1 to a size that it does not know, and no scan is that large.
void forgetInventedSize(ScanChannel& channel) {
    HeightMap& map = channel.map;
    const auto isInvented = [](double size) { return std::abs(size - 1.0) < 1e-9; };
    if (isInvented(map.sizeX()) || isInvented(map.sizeY())) {
        map.pitchX = map.pitchY = 0.0;
        channel.lateralUnit.clear();
        std::erase_if(channel.provenance,
                      [](const Provenance& entry) { return entry.what == "lateral size"; });
        std::erase_if(channel.notes, [](const std::string& note) {
            return note.find("meters are assumed") != std::string::npos;
        });
        channel.notes.emplace_back("Gwyddion gives it a side of 1, as it does when the file holds "
                                   "no lateral size: the size is taken as unknown");
        channel.notes.emplace_back(kNoSizeNote);
    }
}

/// Keys by which Gwyddion's modules keep the unit of the values as the file gives it, without all
/// but letters.
constexpr std::array<std::string_view, 11> kUnitKeys{
    "unit",       "units",     "zunit",       "zunits",   "dataunit",   "dataunits",
    "valueunits", "valueunit", "sampleunits", "physunit", "channelunit"};

std::string lettersOf(std::string_view text) {
    std::string letters;
    std::ranges::copy_if(lowerCase(text), std::back_inserter(letters),
                         [](char c) { return c >= 'a' && c <= 'z'; });
    return letters;
}

/// Returns whether the unit "A" of such a channel is the ångström.
bool namesHeight(const std::string& channel) {
    const std::string name = lowerCase(channel);
    return name.find("topograph") != std::string::npos ||
           name.find("height") != std::string::npos || name == "z" || name.starts_with("z ");
}

/// A unit of the file's own that Gwyddion does not give the values.
struct OwnUnit {
    std::string text;     ///< as the file writes it
    std::string base;     ///< of SI
    double factor = 1.0;  ///< from Gwyddion's values to those in this unit
};

/// Gwyddion takes the prefix of a unit into its values, but keeps the numbers of the file where it
/// gives none.
std::optional<OwnUnit> ownUnit(const ScanChannel& channel) {
    constexpr std::array<std::string_view, 11> kKnown{"m", "V", "A",  "N",   "Hz", "s",
                                                      "W", "F", "Pa", "deg", "rad"};
    for (const auto& [key, value] : channel.metadata) {
        const std::string_view last = std::string_view(key).substr(key.rfind(':') + 1);
        if (std::ranges::count(kUnitKeys, lettersOf(last)) == 0) {
            continue;
        }
        const bool isAngstrom = trimmed(value) == "A" && namesHeight(channel.name);
        const PhysicalUnit unit = isAngstrom ? parseLengthUnit(value) : parseUnit(value);
        if (std::ranges::count(kKnown, unit.base) > 0 && unit.base != channel.unit) {
            const bool areNumbers = channel.unit.empty() || isAngstrom;
            return OwnUnit{.text = std::string(trimmed(value)),
                           .base = unit.base,
                           .factor = areNumbers ? unit.factor : 1.0};
        }
    }
    return std::nullopt;
}

/// The unit in the file's metadata wins over the one that Gwyddion gives the values.
void takeOwnUnit(StoredChannel& stored) {
    ScanChannel& channel = stored.channel;
    const std::optional<OwnUnit> own = ownUnit(channel);
    if (!own) {
        return;
    }
    channel.notes.push_back(
        "Gwyddion gives its values " +
        (channel.unit.empty() ? std::string("no unit") : "the unit '" + channel.unit + "'") +
        ", but the file's metadata name '" + own->text + "', which is taken");
    channel.unit = own->base;
    stored.factor *= own->factor;
    std::erase_if(channel.provenance,
                  [](const Provenance& entry) { return entry.what == "scale"; });
    channel.provenance.push_back(
        scaleProvenance(stored.factor, own->base, "the unit in the file's metadata"));
}

/// Marks an interferometer's phase as the surface itself, in meters.
void markSurface(ScanChannel& channel, const Identification& found) {
    if (found.module == "metropro" && lowerCase(channel.name).starts_with("phase") &&
        channel.isHeight()) {
        channel.isSurface = true;
    }
}

class GwyddionImport {
public:
    GwyddionImport(const ByteSource& bytes, const Gwyddion& gwyddion, const std::string& unknown)
        : bytes_(bytes)
        , gwyddion_(gwyddion)
        , unknown_(unknown)
        , deadline_(std::chrono::steady_clock::now() + gwyddion.timeout)
        , input_(folder_.path() / "scan" / plainName(bytes.name()))
        , output_(folder_.path() / "converted.gwy") {}

    GwyddionScan read() {
        copyContent();
        const Identification found = identify();
        const std::shared_ptr<const ByteSource> converted = convert(found);
        const std::string version = versionIn(run({"--version"}).output);
        GwyddionScan result{.format = found.name + ", through Gwyddion " + version,
                            .scan = kGwyFormat.read(*converted)};
        for (StoredChannel& stored : result.scan.channels) {
            stored.readRow = keeping(std::move(stored.readRow), converted);
            forgetInventedSize(stored.channel);
            takeOwnUnit(stored);
            markSurface(stored.channel, found);
        }
        result.scan.provenance.push_back(
            {"reader", "through Gwyddion " + version + ", its module " + found.module,
             "no format of Asperity's recognizes the file; Gwyddion does with a score of " +
                 std::to_string(found.score)});
        return result;
    }

private:
    void copyContent() const {
        makeFolder(input_.parent_path());
        makeFolder(folder_.path() / ".gwyddion");  // else it complains
        copyTo(bytes_, input_);
    }

    [[nodiscard]] Identification identify() const {
        const ProgramOutcome outcome = run({"--identify", input_.string()});
        const std::optional<Identification> found =
            identificationIn(outcome.output, input_.string());
        if (!found) {
            fail(unknown_ + "; Gwyddion does not recognize it, either");
        }
        if (!found->isCertain()) {
            fail(unknown_ + "; Gwyddion only guesses: " + found->name + ", with a score of " +
                 std::to_string(found->score) + " of 100");
        }
        if (found->isPicture()) {
            fail(pictureRefusal(found->name));
        }
        return *found;
    }

    /// The .gwy, which stays open and has no name any more when the folder is removed.
    [[nodiscard]] std::shared_ptr<const ByteSource> convert(const Identification& found) const {
        const ProgramOutcome outcome =
            run({"--convert-to-gwy=" + output_.string(), input_.string()});
        std::error_code ignored;
        if (outcome.exitCode != 0 || !std::filesystem::exists(output_, ignored)) {
            fail("Gwyddion takes this for " + found.name + " (module " + found.module +
                 ") and cannot read it" + quoted(outcome.output));
        }
        auto converted =
            std::make_shared<FileBytes>(output_, bytes_.name() + ": as Gwyddion converts it");
        if (!kGwyFormat.recognizes(*converted)) {
            fail("what Gwyddion made of it is no .gwy file");
        }
        return converted;
    }

    [[nodiscard]] ProgramOutcome run(std::vector<std::string> arguments) const {
        const std::string home = folder_.path().string();
        ProgramOutcome outcome = runProgram(
            {.program = gwyddion_.program,
             .arguments = std::move(arguments),
             .environment = {"PATH=" + gwyddion_.program.parent_path().string() + ":/usr/bin:/bin",
                             "HOME=" + home, "TMPDIR=" + home, "LC_ALL=C.UTF-8"},
             .folder = folder_.path(),
             .deadline = deadline_});
        switch (outcome.end) {
        case ProgramEnd::Exited:
            return outcome;
        case ProgramEnd::Killed:
            fail("Gwyddion cannot read it: it crashed, or its result was too large" +
                 quoted(outcome.output));
        case ProgramEnd::TimedOut:
            fail("Gwyddion did not end within " +
                 exactText(std::chrono::duration<double>(gwyddion_.timeout).count()) + " s");
        case ProgramEnd::WroteTooMuch:
            fail("Gwyddion cannot read it: it printed messages without end");
        }
        return outcome;
    }

    /// Gwyddion's own words, those on this file where there are any.
    [[nodiscard]] std::string quoted(const std::string& output) const {
        const std::string mark = input_.string() + ": ";
        const std::size_t own = output.find(mark);
        const std::string_view words =
            trimmed(own == std::string::npos ? std::string_view()
                                             : std::string_view(output).substr(own + mark.size()));
        const std::string_view line = words.substr(0, std::min(words.find('\n'), kMaxQuote));
        return line.empty() ? "" : ": " + toUtf8(line);
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(bytes_.name(), "", what);
    }

    const ByteSource& bytes_;
    const Gwyddion& gwyddion_;
    const std::string& unknown_;
    std::chrono::steady_clock::time_point deadline_;
    PrivateFolder folder_;
    std::filesystem::path input_;
    std::filesystem::path output_;
};

}  // namespace

Gwyddion gwyddionIn(std::string_view folders) {
    return {.program = findProgram(kProgram, folders)};
}

Gwyddion installedGwyddion() { return {.program = findProgram(kProgram)}; }

GwyddionScan readThroughGwyddion(const ByteSource& bytes, const Gwyddion& gwyddion,
                                 const std::string& unknown) {
    return GwyddionImport(bytes, gwyddion, unknown).read();
}

}  // namespace asperity
