#include "app/commands/FitOptions.h"

#include "app/commands/OptionChecks.h"
#include "core/Error.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>

namespace asperity {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;  // [rad]

constexpr const char* kTipForms = "sphere:R, paraboloid:R, conesphere:R,ANGLE, cone:ANGLE, "
                                  "pyramid3:ANGLE, pyramid4:ANGLE or area:FILE, such as sphere:5um";

/// An angle in radians, or with "deg" or "rad"; none where the text is neither.
std::optional<double> parseAngle(const std::string& text) {
    const auto degrees = parseQuantity(text, "deg");
    const bool isBare = parseNumber(text).has_value();
    return isBare || !degrees ? parseQuantity(text, "rad") : std::optional(*degrees * kDegree);
}

double required(const std::optional<double>& value, const std::string& text, const char* what) {
    if (!value || !(*value > 0.0)) {
        throw Error("expected " + std::string(what) + " above 0, not '" + text + "'");
    }
    return *value;
}

/// The option of a quantity above 0 with its unit.
CLI::Option* addQuantity(CLI::App& command, const std::string& name, const char* unit,
                         const std::string& what, const std::function<void(double)>& take) {
    const auto parse = [unit](const std::string& text) {
        const std::string expected = "a number with the unit " + std::string(unit);
        return required(parseQuantity(text, unit), text, expected.c_str());
    };
    return command
        .add_option_function<std::string>(
            name, [parse, take](const std::string& text) { take(parse(text)); }, what)
        ->check(acceptedBy(parse));
}

/// The option of one of an enum's keys.
template <class Value>
void addChoice(CLI::App& command, const std::string& name, Value& value,
               const std::vector<std::string>& keys, const std::string& what) {
    command
        .add_option_function<std::string>(
            name, [&value](const std::string& key) { value = *fromKey<Value>(key); }, what)
        ->check(CLI::IsMember(keys));
}

/// "1nN:5nN"; none where it is not that.
std::optional<ForceWindow> parseWindow(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) {
        return std::nullopt;
    }
    const auto low = parseQuantity(text.substr(0, colon), "N");
    const auto high = parseQuantity(text.substr(colon + 1), "N");
    return low && high && *low < *high ? std::optional(ForceWindow{*low, *high}) : std::nullopt;
}

void addLeverOptions(CLI::App& command, FitRequest& request) {
    PreparationOptions& steps = request.fit.curve.preparation;
    CLI::Option* const stiffness = addQuantity(command, "--stiffness", "N/m",
                                               "spring constant of the lever instead of the file's",
                                               [&steps](double value) { steps.stiffness = value; });
    command
        .add_option("--sader", request.probe,
                    "probe file (.toml): spring constant by Sader's method from its length, width, "
                    "resonance and quality factor in air")
        ->check(notEmpty())
        ->excludes(stiffness);
    command
        .add_option("--thermal", request.spectrum,
                    "thermal spectrum of the lever (.nid): spring constant by its fundamental mode")
        ->check(notEmpty())
        ->excludes(stiffness)
        ->excludes(command.get_option("--sader"));
    addQuantity(command, "--temperature", "K", "of the lever in that spectrum [default: 295]",
                [&request](double value) { request.temperature = value; });
    addQuantity(command, "--invols", "m/V",
                "inverse optical lever sensitivity instead of the file's, such as 50nm/V",
                [&steps](double value) { steps.invols = value; });
    addChoice(command, "--lever", steps.lever, {"thermal", "fixed"},
              "correct the InvOLS, by the slope of a hard contact or as a parameter of an adhesive "
              "law; the spring constant goes with it (thermal: from a thermal spectrum with the "
              "same InvOLS) or stays (fixed)");
    command
        .add_option_function<std::vector<std::string>>(
            "--without",
            [&steps](const std::vector<std::string>& names) {
                for (const std::string& name : names) {
                    (name == "sign"       ? steps.sign
                     : name == "baseline" ? steps.baseline
                     : name == "tilt"     ? steps.tilt
                                          : steps.drag) = false;
                }
            },
            "leave a step out: sign, baseline, tilt or drag; may be given again")
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"sign", "baseline", "tilt", "drag"}));
}

void addContactOptions(CLI::App& command, FitRequest& request) {
    CurveFitOptions& fit = request.fit.curve;
    std::vector<std::string> methods;
    for (const ContactMethod method : kValues<ContactMethod>) {
        methods.emplace_back(keyOf(method));
    }
    addChoice(command, "--contact", fit.contact, methods,
              "method for the contact point (default: model, a parameter of the fit)");
    command
        .add_option_function<std::string>(
            "--range", [&fit](const std::string& text) { fit.window = parseWindow(text); },
            "forces FMIN:FMAX above the baseline that are fitted, such as 1nN:5nN; default: all")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return parseWindow(text) ? std::string()
                                         : "expected FMIN:FMAX, forces such as 1nN:5nN with FMIN "
                                           "below FMAX, not '" +
                                               text + "'";
            },
            "FMIN:FMAX"));
}

/// The option of a term of the model: on or off.
void addSwitch(CLI::App& command, const std::string& name, bool& value, const std::string& what) {
    command
        .add_option_function<std::string>(
            name, [&value](const std::string& word) { value = word == "on"; }, what)
        ->check(CLI::IsMember({"on", "off"}));
}

void addModelOptions(CLI::App& command, FitRequest& request) {
    CycleFitOptions& fit = request.fit;
    const auto keys = [](const auto& values) {
        std::vector<std::string> list;
        for (const auto value : values) {
            list.emplace_back(keyOf(value));
        }
        return list;
    };
    addChoice(command, "--law", fit.law, keys(kValues<SampleLaw>),
              "contact law (default: elastic; auto: by the Tabor number that is found)");
    command
        .add_option_function<std::string>(
            "--adhesion", [&fit](const std::string& word) { fit.twoWorks = word == "two"; },
            "one (default) work of adhesion, or two: on approach and on retract, with law jkr")
        ->check(CLI::IsMember({"one", "two"}));
    addSwitch(command, "--relaxation", fit.relaxation,
              "a sample that relaxes as a standard linear solid, with law elastic");
    addSwitch(command, "--drag", fit.drag, "drag of the tip by the wall, with law elastic");
    addChoice(command, "--branch", fit.branch, keys(kValues<FittedBranch>),
              "both (default), approach or retract: what is fitted; the other is predicted. An "
              "elastic fit without relaxation and drag always takes one, by default the approach, "
              "and with --branch approach looks at nothing else");
    command.add_flag("--compare", fit.compares,
                     "fit all models that the curve can carry, and rank them");
}

void addSampleOptions(CLI::App& command, FitRequest& request) {
    CurveFitOptions& fit = request.fit.curve;
    command
        .add_option_function<std::string>(
            "--tip",
            [&](const std::string& text) {
                const NamedTip tip = parseTip(text);
                request.fit.curve.tip = tip.form;
                request.area = tip.area;
            },
            std::string("shape of the tip: ") + kTipForms +
                "; angles are between face and axis; without it no modulus is given")
        ->check(acceptedBy([](const std::string& text) { return parseTip(text); }));
    command.add_option("--nu", fit.poissonRatio, "Poisson's ratio of the sample")
        ->check(CLI::Range(0.0, 0.5))
        ->capture_default_str();
    addQuantity(command, "--film", "m",
                "thickness of the sample, a film on a rigid base, under a paraboloid",
                [&fit](double value) { fit.filmThickness = value; });
}

void addDeviationOptions(CLI::App& command, FitRequest& request) {
    CalibrationDeviations& off = request.fit.curve.deviations;
    const auto share = [&command](const char* name, double& value, const char* of) {
        command.add_option(name, value, std::string("relative standard deviation of ") + of)
            ->check(CLI::Range(0.0, 1.0))
            ->capture_default_str();
    };
    share("--std-stiffness", off.stiffness, "the spring constant");
    share("--std-invols", off.invols, "the InvOLS");
    share("--std-radius", off.tipRadius, "the tip's radius");
    command
        .add_option_function<std::string>(
            "--std-angle",
            [&off](const std::string& text) { off.tipAngle = parseAngle(text).value_or(0.0); },
            "standard deviation of the tip's angle [default: 2deg]")
        ->check(acceptedBy(
            [](const std::string& text) { return required(parseAngle(text), text, "an angle"); }));
}

}  // namespace

NamedTip parseTip(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto kind = fromKey<TipKind>(text.substr(0, colon));
    if (colon == std::string::npos || colon + 1 == text.size() || !kind) {
        throw Error(std::string("expected a tip as ") + kTipForms + ", not '" + text + "'");
    }
    if (*kind == TipKind::Area) {
        return {.form = {.kind = *kind}, .area = text.substr(colon + 1)};
    }
    TipForm tip{.kind = *kind};
    const std::string values = text.substr(colon + 1);
    const std::size_t comma =
        hasRadius(*kind) && hasAngle(*kind) ? values.find(',') : values.size();
    if (comma == std::string::npos) {
        throw Error("expected conesphere:R,ANGLE, not '" + text + "'");
    }
    if (hasRadius(*kind)) {
        const std::string radius = values.substr(0, comma);
        tip.radius = required(parseQuantity(radius, "m"), radius, "a radius such as 18.64um");
    }
    if (hasAngle(*kind)) {
        const std::string angle = hasRadius(*kind) ? values.substr(comma + 1) : values;
        tip.angle = required(parseAngle(angle), angle, "an angle such as 20deg");
    }
    (void)TipLaw(tip, {}, 1e-6);  // refuses what is out of range
    return {.form = tip, .area = {}};
}

void addFitOptions(CLI::App& command, FitRequest& request) {
    command
        .add_option("CURVE", request.curves,
                    "file of a force-distance curve; of several, a table of results is written")
        ->required()
        ->check(notEmpty());
    addOutputFolder(command, request.out,
                    "folder for fit.json, curve.csv, simulated.csv and fit.png; of several curves "
                    "for fits.csv and fits.json");
    addForce(command, request.force);
    addCurveFileOptions(command, request.read);
    command
        .add_flag("--all", request.all,
                  "fit all curves of each file, on all cores; of one file whose curves lie on a "
                  "grid, maps.gwy has the results as images")
        ->excludes(command.get_option("--index"));
    addModelOptions(command, request);
    addSampleOptions(command, request);
    addLeverOptions(command, request);
    addContactOptions(command, request);
    addDeviationOptions(command, request);
}

}  // namespace asperity
