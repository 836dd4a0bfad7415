#include "app/commands/DecoupleCommand.h"

#include "app/commands/CaseFiles.h"
#include "app/commands/OptionChecks.h"
#include "core/io/scene/DecouplingFile.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace asperity {

namespace {

constexpr const char* kCasesHelp =
    "The cases are a CSV table with the columns\n"
    "  nx,ny,nz                 surface normal out of the sample, of any length\n"
    "  vx,vy,vz                 velocity of the tip relative to the sample [m/s]\n"
    "  alpha_rad,theta_rad      bending and torsion signal, with their standard deviations\n"
    "  sigma_alpha_rad,sigma_theta_rad\n"
    "  friction_coefficient,shear_strength_pa,contact_area_m2\n"
    "  normal_force_model_n,normal_force_sigma_n\n"
    "                           normal force of a contact model, with its standard deviation\n"
    "normal_deviation_rad, which a table need not have, is the standard deviation of the normal's\n"
    "direction about each axis across it; without it the normal counts as exact.\n"
    "With inv_ols_m_v and lateral_sensitivity_rad_v in the probe file, vertical_v,lateral_v,\n"
    "sigma_vertical_v,sigma_lateral_v may stand in place of the four columns in radians.\n"
    "All vectors and the covariance are in the lab frame. Added are fx_n,fy_n,fz_n,cxx_n2,cyy_n2,\n"
    "czz_n2,cxy_n2,cxz_n2,cyz_n2,condition,case; the case is regular, near_singular, no_sliding\n"
    "or invalid_input (a NaN, a normal without direction, a deviation that is not positive: the\n"
    "numbers are then nan), followed by implausibilities: |pushes_along |excess_friction\n"
    "|contradicts_model.";

struct DecoupleOptions {
    std::string probe;
    CaseFiles files;
};

void decouple(const DecoupleOptions& options) {
    requireWritableTable(options.files.out, {options.files.cases, options.probe});
    writeTable(options.files.out, [&](std::ostream& out, Progress* progress) {
        writeForceEstimates(options.probe, options.files.cases, out, progress);
    });
}

}  // namespace

void addDecoupleCommand(CLI::App& program) {
    const auto options = std::make_shared<DecoupleOptions>();
    CLI::App* command = program.add_subcommand(
        "decouple",
        "Compute 3-D forces with covariance from lever signals, for each case of a table");
    command->footer(kCasesHelp);
    command->add_option("--probe", options->probe, "probe file (TOML)")
        ->required()
        ->check(notEmpty());
    addCaseFiles(*command, options->files);
    command->callback([options] { decouple(*options); });
}

}  // namespace asperity
