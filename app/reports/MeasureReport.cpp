#include "app/reports/MeasureReport.h"

#include "app/program/JsonText.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kProfileColumns =
    "distance along the line, position in the world frame, height; meters; nan: no data";

std::string degrees(double angle) {
    return formatted("%.4g degrees", angle * 180.0 / std::numbers::pi);
}

std::string positionText(const Vector2& position) {
    return "(" + formatSi(position.x(), "m") + ", " + formatSi(position.y(), "m") + ")";
}

void printLine(std::ostream& out, const char* name, const std::string& value,
               const std::string& meaning) {
    out << formatted("  %-5s", name) << value
        << std::string(value.size() < 12 ? 12 - value.size() : 1, ' ') << meaning << '\n';
}

std::string optionalText(const std::optional<double>& number) {
    return number ? formatted("%.4g", *number) : "-";
}

void printTexture(std::ostream& out, const Texture& texture) {
    const std::string used =
        texture.step > 1 ? ", of one pixel in " + std::to_string(texture.step) + " a side" : "";
    printLine(out, "Sal", texture.sal ? formatSi(*texture.sal, "m") : "-",
              "autocorrelation length" + used);
    printLine(out, "Str", optionalText(texture.str), "texture aspect ratio" + used);
}

void printRoughness(std::ostream& out, const MeasuredMap& measured) {
    const Roughness& roughness = measured.roughness;
    const PixelRectangle& rectangle = measured.rectangle;
    out << "Roughness (ISO 25178-2) of " << roughness.pixels << " pixels with data, "
        << rectangle.columns << " x " << rectangle.rows << " from column " << rectangle.column
        << ", row " << rectangle.row << '\n';
    printLine(out, "Sa", formatSi(roughness.sa, "m"), "arithmetical mean height");
    printLine(out, "Sq", formatSi(roughness.sq, "m"), "root mean square height");
    printLine(out, "Sz", formatSi(roughness.sz, "m"),
              "maximum height, from " + formatSi(roughness.lowest, "m") + " to " +
                  formatSi(roughness.highest, "m") + ", mean " + formatSi(roughness.mean, "m"));
    printLine(out, "Sp", formatSi(roughness.sp, "m"), "maximum peak height, above the mean");
    printLine(out, "Sv", formatSi(roughness.sv, "m"), "maximum pit height, below the mean");
    printLine(out, "Ssk", optionalText(roughness.ssk), "skewness");
    printLine(out, "Sku", optionalText(roughness.sku), "kurtosis");
    printLine(out, "Sdq", formatted("%.4g", roughness.sdq), "root mean square gradient");
    printLine(out, "Sdr", formatted("%.4g %%", 100.0 * roughness.sdr),
              "developed interfacial area ratio");
    printTexture(out, measured.texture);
}

void printStep(std::ostream& out, const char* what, const StepHeight& step) {
    out << "  " << what << ": " << formatSi(step.height, "m") << " (scatter "
        << formatSi(step.deviation, "m") << ", " << step.samples << " samples on " << step.plateaus
        << " plateaus)\n";
}

void printProfile(std::ostream& out, const MeasuredProfile& measured) {
    const Profile& profile = measured.profile;
    out << "Profile from " << positionText(profile.from) << " to " << positionText(profile.to)
        << ", " << formatSi(profile.length(), "m") << ", " << profile.heights.size() << " samples";
    const auto missing = std::ranges::count_if(
        profile.heights, [](double height) { return !isFiniteHeight(height); });
    out << (missing > 0 ? ", " + std::to_string(missing) + " of them without data\n" : "\n");
    if (measured.ends) {
        out << "  end over start: " << formatSi(measured.ends->rise, "m") << ", angle "
            << degrees(measured.ends->angle) << '\n';
    }
    if (measured.fittedAngle) {
        out << "  angle of the fitted line: " << degrees(*measured.fittedAngle) << '\n';
    }
    if (measured.grating) {
        printStep(out, "height of a grating", *measured.grating);
    }
    if (measured.twoLevels) {
        printStep(out, "step height", *measured.twoLevels);
    }
}

Json optionalJson(const std::optional<double>& number) {
    return number ? Json(*number) : Json(nullptr);
}

Json stepJson(const std::optional<StepHeight>& step) {
    if (!step) {
        return nullptr;
    }
    return {{"height_m", step->height},
            {"deviation_m", step->deviation},
            {"samples", step->samples},
            {"plateaus", step->plateaus}};
}

Json profileJson(const MeasuredProfile& measured) {
    const Profile& profile = measured.profile;
    Json ends = nullptr;
    if (measured.ends) {
        ends = {{"rise_m", measured.ends->rise}, {"angle_rad", measured.ends->angle}};
    }
    return {{"from_m", {profile.from.x(), profile.from.y()}},
            {"to_m", {profile.to.x(), profile.to.y()}},
            {"length_m", profile.length()},
            {"samples", profile.heights.size()},
            {"ends", ends},
            {"fitted_angle_rad", optionalJson(measured.fittedAngle)},
            {"grating", stepJson(measured.grating)},
            {"step", stepJson(measured.twoLevels)}};
}

const std::vector<std::string>& roughnessColumns() {
    static const std::vector<std::string> kColumns{
        "file", "channel", "width_m", "height_m", "pixels", "Sa_m", "Sq_m",  "Ssk",
        "Sku",  "Sp_m",    "Sv_m",    "Sz_m",     "Sdq",    "Sdr",  "Sal_m", "Str"};
    return kColumns;
}

void addCell(CsvWriter& csv, const std::optional<double>& number) {
    if (number) {
        csv.add(*number);
    } else {
        csv.add(std::string_view());
    }
}

}  // namespace

void printMeasures(std::ostream& out, const MeasuredMap& measured) {
    out << printable(measured.file) << ", channel '" << printable(measured.channel) << "', "
        << measured.columns << " x " << measured.rows << " pixels, "
        << formatSi(measured.sizeX, "m") << " x " << formatSi(measured.sizeY, "m") << '\n';
    for (const std::string& note : measured.notes) {
        out << "- " << printable(note) << '\n';
    }
    printRoughness(out, measured);
    if (measured.profile) {
        printProfile(out, *measured.profile);
    }
}

std::string measuresJson(const MeasuredMap& measured) {
    const Roughness& roughness = measured.roughness;
    const PixelRectangle& rectangle = measured.rectangle;
    return jsonText(
        Json{{"file", pathText(measured.file)},
             {"channel", measured.channel},
             {"level", measured.leveling},
             {"columns", measured.columns},
             {"rows", measured.rows},
             {"size_x_m", measured.sizeX},
             {"size_y_m", measured.sizeY},
             {"rectangle",
              {{"column", rectangle.column},
               {"row", rectangle.row},
               {"columns", rectangle.columns},
               {"rows", rectangle.rows}}},
             {"pixels", roughness.pixels},
             {"squares", roughness.squares},
             {"sa_m", roughness.sa},
             {"sq_m", roughness.sq},
             {"sz_m", roughness.sz},
             {"sp_m", roughness.sp},
             {"sv_m", roughness.sv},
             {"ssk", optionalJson(roughness.ssk)},
             {"sku", optionalJson(roughness.sku)},
             {"sdq", roughness.sdq},
             {"sdr", roughness.sdr},
             {"sal_m", optionalJson(measured.texture.sal)},
             {"str", optionalJson(measured.texture.str)},
             {"texture_step", measured.texture.step},
             {"mean_m", roughness.mean},
             {"lowest_m", roughness.lowest},
             {"highest_m", roughness.highest},
             {"profile", measured.profile ? profileJson(*measured.profile) : Json(nullptr)},
             {"notes", measured.notes}});
}

RoughnessTable::RoughnessTable(std::ostream& out) : csv_(out, {}, roughnessColumns()) {}

RoughnessTable::RoughnessTable(const std::filesystem::path& file,
                               const std::vector<std::string>& comments)
    : csv_(file, comments, roughnessColumns()) {}

void RoughnessTable::add(const std::string& file, const MeasuredMap& measured) {
    const Roughness& roughness = measured.roughness;
    const PixelRectangle& part = measured.rectangle;
    csv_.add(file).add(measured.channel);
    csv_.add(measured.sizeX * part.columns / measured.columns);
    csv_.add(measured.sizeY * part.rows / measured.rows);
    csv_.add(static_cast<double>(roughness.pixels)).add(roughness.sa).add(roughness.sq);
    addCell(csv_, roughness.ssk);
    addCell(csv_, roughness.sku);
    csv_.add(roughness.sp).add(roughness.sv).add(roughness.sz);
    csv_.add(roughness.sdq).add(roughness.sdr);
    addCell(csv_, measured.texture.sal);
    addCell(csv_, measured.texture.str);
    csv_.endRow();
    csv_.flush();
}

void RoughnessTable::addUnmeasured(const std::string& file) {
    csv_.add(file);
    for (std::size_t i = 1; i < roughnessColumns().size(); ++i) {
        csv_.add(std::string_view());
    }
    csv_.endRow();
    csv_.flush();
}

std::vector<std::string> provenanceOf(const MeasuredMap& measured, const std::string& what) {
    std::vector<std::string> lines{std::string("Asperity ") + kVersion + ": " + what + " of " +
                                   measured.file + ", channel " + measured.channel};
    lines.insert(lines.end(), measured.notes.begin(), measured.notes.end());
    return lines;
}

void writeProfile(std::ostream& out, const MeasuredMap& measured, const Profile& profile) {
    std::vector<std::string> comments = provenanceOf(measured, "profile");
    comments.emplace_back(kProfileColumns);
    CsvWriter csv(out, comments, {"distance_m", "x_m", "y_m", "z_m"});
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        const Vector2 point = profile.position(i);
        csv.row(std::array{profile.distance(i), point.x(), point.y(), profile.heights[i]});
    }
    csv.close();
}

void writeProfiles(const std::filesystem::path& file, std::vector<std::string> comments,
                   const std::vector<NamedProfile>& profiles) {
    comments.emplace_back(kProfileColumns);
    CsvWriter csv(file, comments, {"profile", "distance_m", "x_m", "y_m", "z_m"});
    for (const auto& [name, profile] : profiles) {
        for (std::size_t i = 0; i < profile.heights.size(); ++i) {
            const Vector2 point = profile.position(i);
            csv.add(name).add(profile.distance(i)).add(point.x()).add(point.y());
            csv.add(profile.heights[i]).endRow();
        }
    }
    csv.close();
}

void writeHistogram(const std::filesystem::path& file, std::vector<std::string> comments,
                    const HeightHistogram& histogram) {
    comments.emplace_back("middle of each bin, pixels in it, their share of the area, share of the "
                          "area above the bin's lower edge");
    CsvWriter csv(file, comments, {"height_m", "pixels", "share", "share_above"});
    double all = 0.0;
    for (const std::size_t count : histogram.counts) {
        all += static_cast<double>(count);
    }
    double above = all;
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        const auto count = static_cast<double>(histogram.counts[bin]);
        csv.row(std::array{histogram.middle(bin), count, count / all, above / all});
        above -= count;
    }
    csv.close();
}

void writeSpectrum(const std::filesystem::path& file, std::vector<std::string> comments,
                   const PowerSpectrum& spectrum) {
    comments.emplace_back("areal power spectral density, Hann window, mean over all directions; "
                          "Sq^2 is the sum of psd_m4 * waves * " +
                          formatted("%.17g", spectrum.waveArea) + " 1/m^2");
    CsvWriter csv(file, comments, {"frequency_1_m", "psd_m4", "waves"});
    for (const SpectrumRing& ring : spectrum.rings) {
        csv.row(std::array{ring.frequency, ring.density, ring.waves});
    }
    csv.close();
}

}  // namespace asperity
