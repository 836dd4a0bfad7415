#include "app/curves/FitFiles.h"

#include "app/charts/ChartFile.h"
#include "app/program/JsonText.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

Json valueJson(const IdentifiedValue& value) {
    Json json{{"value", value.value}};
    json["std"] = value.std > 0.0 ? Json(value.std) : Json(nullptr);
    json["std_calibration"] =
        value.stdCalibration > 0.0 ? Json(value.stdCalibration) : Json(nullptr);
    json["unit"] = value.unit;
    json["source"] = keyOf(value.source);
    return json;
}

Json valuesJson(const std::vector<IdentifiedValue>& values) {
    Json json = Json::object();
    for (const IdentifiedValue& value : values) {
        json[value.key] = valueJson(value);
    }
    return json;
}

Json numbersJson(const std::vector<FitNumber>& numbers) {
    Json json = Json::object();
    for (const FitNumber& number : numbers) {
        json[number.key] = number.value;
    }
    return json;
}

Json stepsJson(const std::vector<PreparationStep>& steps) {
    Json json = Json::array();
    for (const PreparationStep& step : steps) {
        Json entry{{"step", step.key}, {"on", step.on}, {"values", valuesJson(step.values)}};
        if (!step.note.empty()) {
            entry["note"] = step.note;
        }
        json.push_back(std::move(entry));
    }
    return json;
}

Json optionalJson(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json comparisonJson(const ModelComparison& comparison) {
    Json json{{"best", comparison.best ? Json(keyOf(*comparison.best)) : Json(nullptr)},
              {"reasons", comparison.reasons},
              {"independent_samples", comparison.independentSamples},
              {"models", Json::array()}};
    for (const ComparedModel& model : comparison.ranked) {
        json["models"].push_back({{"model", keyOf(model.model)},
                                  {"rms", model.rms},
                                  {"criterion", model.criterion},
                                  {"rms_unseen_approach", optionalJson(model.unseenApproach)},
                                  {"rms_unseen_retract", optionalJson(model.unseenRetract)},
                                  {"not_identified", model.notIdentified}});
    }
    return json;
}

/// A line for each compared model, the best first.
void addComparison(const ModelComparison& comparison, std::vector<std::string>& lines) {
    lines.push_back(comparison.best ? std::string("  best model: ") + nameOf(*comparison.best)
                                    : std::string("  best model: undecided"));
    for (const ComparedModel& model : comparison.ranked) {
        std::string line = formatted("    %-30s rms %.3f %%, criterion %.1f", nameOf(model.model),
                                     100.0 * model.rms, model.criterion);
        if (model.unseenApproach) {
            line += formatted(", unseen approach %.3f %%", 100.0 * *model.unseenApproach);
        }
        if (model.unseenRetract) {
            line += formatted(", unseen retract %.3f %%", 100.0 * *model.unseenRetract);
        }
        lines.push_back(line);
    }
    for (const std::string& reason : comparison.reasons) {
        lines.push_back("    " + reason);
    }
}

/// Calls write(branch key, whether it was fitted, branch) for each branch that the curve has.
void forEachBranch(const CurveIdentification& found,
                   const std::function<void(const char*, bool, const ComparedBranch&)>& write) {
    write("approach", found.fitsApproach, found.approach);
    if (!found.retract.corrected.empty()) {
        write("retract", found.fitsRetract, found.retract);
    }
}

/// Of a branch: it was fitted, or follows from a fit to the other one.
const char* roleOf(bool isFitted) { return isFitted ? "fitted" : "predicted"; }

double valueOf(const CurveIdentification& found, const std::string& key) {
    const IdentifiedValue* const value = found.find(key);
    return value != nullptr ? value->value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> headerOf(const FittedCurve& curve, const std::string& what) {
    return {std::string("Asperity ") + kVersion + ": " + what,
            "curve " + std::to_string(curve.index) + " of " + curve.file,
            "base towards the sample, force > 0 repulsive, separation < 0: indented"};
}

Curve lineOf(const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
             bool measured) {
    return {.label = label, .x = x, .y = y, .points = measured, .dotSize = 3.0};
}

/// The part of the separation in which tip and sample act on each other: as wide as five times the
/// indentation.
std::optional<ChartRange> nearContact(const CurveIdentification& found) {
    constexpr double kFar = 4.0;
    double deepest = 0.0;
    for (const double separation : found.approach.separation) {
        deepest = std::min(deepest, separation);
    }
    return deepest < 0.0 ? std::optional(ChartRange{1.1 * deepest, -kFar * deepest}) : std::nullopt;
}

/// Separation of the simulated tip and the sample [m].
std::vector<double> simulatedSeparation(const CurveIdentification& found,
                                        const ComparedBranch& branch) {
    const double contact = valueOf(found, "contact_point_m");
    const double stiffness = valueOf(found, "stiffness_n_m");
    std::vector<double> result(branch.forward.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = contact - branch.measured.base[i] + (branch.forward[i] / stiffness);
    }
    return result;
}

std::string summaryOf(const IdentifiedValue& value) {
    const auto shown = [&value](double number) {  // a number without a unit has no prefix either
        return value.unit.empty() ? formatted("%.3g", number)
                                  : formatSi(number, value.unit.c_str());
    };
    std::string text = value.key + " " + shown(value.value);
    if (value.std > 0.0 && std::isfinite(value.std)) {
        text += " ± " + shown(value.std) + " (noise)";
    }
    if (value.stdCalibration > 0.0) {
        text += " ± " + shown(value.stdCalibration) + " (calibration)";
    }
    return text + ", " + keyOf(value.source);
}

}  // namespace

nlohmann::ordered_json fitJson(const FittedCurve& curve) {
    const CurveIdentification& found = curve.found;
    Json json{{"program", std::string("Asperity ") + kVersion},
              {"file", pathText(curve.file)},
              {"sha256", curve.sha256},
              {"index", curve.index},
              {"model", found.model},
              {"verdict", keyOf(found.verdict)},
              {"reasons", found.reasons},
              {"parameters", valuesJson(found.parameters)},
              {"force_range_n", found.forceRange},
              {"noise_n", found.noise},
              {"residuals", numbersJson(found.residuals)}};
    if (!curve.heightChannel.empty()) {
        json["height_channel"] = curve.heightChannel;
    }
    if (!curve.notes.empty()) {
        json["notes"] = curve.notes;
    }
    json["variants"] = Json::object();
    for (const FitVariant& variant : found.variants) {
        json["variants"][variant.key] = {{"parameters", valuesJson(variant.parameters)},
                                         {"residuals", numbersJson(variant.residuals)}};
    }
    if (curve.comparison) {
        json["comparison"] = comparisonJson(*curve.comparison);
    }
    json["correlations"] = Json::array();
    for (const FitCorrelation& pair : found.correlations) {
        json["correlations"].push_back(
            {{"first", pair.first}, {"second", pair.second}, {"value", pair.value}});
    }
    json["tests"] = numbersJson(found.tests);
    json["contact_points_m"] = numbersJson(found.contactPoints);
    json["preparation"] = stepsJson(found.steps);
    return json;
}

void writeFitJson(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
    OutputFile file(path);
    file.stream() << jsonText(json) << '\n';
    file.commit();
}

void writeMeasuredCurve(const std::filesystem::path& path, const FittedCurve& curve) {
    const double stiffness = valueOf(curve.found, "stiffness_n_m");
    CsvWriter csv(path, headerOf(curve, "measured curve"),
                  {"branch", "time_s", "base_m", "deflection_m", "force_n", "corrected_force_n",
                   "separation_m"});
    forEachBranch(
        curve.found, [&](const char* key, bool /*isFitted*/, const ComparedBranch& branch) {
            const BranchSamples& measured = branch.measured;
            for (std::size_t i = 0; i < measured.size(); ++i) {
                csv.add(key).add(measured.time.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                       : measured.time[i]);
                csv.add(measured.base[i]).add(measured.force[i] / stiffness).add(measured.force[i]);
                csv.add(branch.corrected[i]).add(branch.separation[i]).endRow();
            }
        });
    csv.close();
}

void writeSimulatedCurve(const std::filesystem::path& path, const FittedCurve& curve) {
    CsvWriter csv(path,
                  headerOf(curve, "force_n and separation_m simulated from the motion of the base "
                                  "alone, fitted_force_n at the measured indentation"),
                  {"branch", "role", "base_m", "force_n", "separation_m", "fitted_force_n"});
    forEachBranch(curve.found, [&](const char* key, bool isFitted, const ComparedBranch& branch) {
        const std::vector<double> separation = simulatedSeparation(curve.found, branch);
        for (std::size_t i = 0; i < branch.forward.size(); ++i) {
            csv.add(key).add(roleOf(isFitted));
            csv.add(branch.measured.base[i]).add(branch.forward[i]);
            csv.add(separation[i]).add(branch.fitted[i]).endRow();
        }
    });
    csv.close();
}

void writeFitFigure(const std::filesystem::path& path, const FittedCurve& curve) {
    Chart overSeparation{.title =
                             nameOf(curve.found.verdict) + std::string(": ") + curve.found.model,
                         .xLabel = "tip-sample separation",
                         .yLabel = "force on the tip",
                         .curves = {},
                         .xUnit = "m",
                         .yUnit = "N",
                         .xRange = nearContact(curve.found)};
    Chart overBase = overSeparation;
    overBase.xRange.reset();
    overBase.title.clear();
    overBase.xLabel = "base position towards the sample";
    forEachBranch(curve.found, [&](const char* key, bool isFitted, const ComparedBranch& branch) {
        const std::string name = std::string(", ") + key;
        const std::string simulated = "simulated" + name + ", " + roleOf(isFitted);
        overSeparation.curves.push_back(
            lineOf("measured" + name, branch.separation, branch.corrected, true));
        overBase.curves.push_back(
            lineOf("measured" + name, branch.measured.base, branch.corrected, true));
        overSeparation.curves.push_back(
            lineOf(simulated, simulatedSeparation(curve.found, branch), branch.forward, false));
        overBase.curves.push_back(lineOf(simulated, branch.measured.base, branch.forward, false));
    });
    const std::array charts{overSeparation, overBase};
    writePng(path, layOut(charts, {.width = 1600.0, .height = 700.0, .columns = 2}));
}

std::vector<std::string> fitSummary(const FittedCurve& curve) {
    std::vector<std::string> lines{curve.file + ", curve " + std::to_string(curve.index) + ": " +
                                   nameOf(curve.found.verdict) + ", " + curve.found.model};
    for (const IdentifiedValue& value : curve.found.parameters) {
        lines.push_back("  " + summaryOf(value));
    }
    for (const std::string& reason : curve.found.reasons) {
        lines.push_back("  " + reason);
    }
    if (curve.comparison) {
        addComparison(*curve.comparison, lines);
    }
    return lines;
}

}  // namespace asperity
