#pragma once

#include "core/io/tables/CsvTable.h"

#include <string>

namespace asperity::test {

/// The columns of `asperity contact`, as a line.
inline constexpr const char* kContactHeader =
    "model,radius_m,e_star_pa,work_of_adhesion_j_m2,sigma0_pa,indentation_m,branch\n";

/// The same with those of a film.
inline constexpr const char* kFilmHeader =
    "model,radius_m,e_star_pa,work_of_adhesion_j_m2,sigma0_pa,indentation_m,branch,"
    "film_thickness_m,poisson_ratio\n";

/// One case of `asperity contact`; numbers as in a reference table.
struct ContactRow {
    std::string model;
    std::string radius;
    std::string modulus;
    std::string work;
    std::string stress;
    double indentation = 0.0;
    std::string branch = "retract";
};

/// As a line of its table.
[[nodiscard]] std::string lineOf(const ContactRow& row);

/// Runs `asperity contact` on these lines and returns its table. Anything but success fails the
/// calling test.
[[nodiscard]] CsvTable contactTable(const std::string& lines,
                                    const std::string& header = kContactHeader);

}  // namespace asperity::test
