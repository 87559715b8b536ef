// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_EVIDENCE_TEXT_H
#define CORRAL_SRC_PROGRAM_AUDIT_EVIDENCE_TEXT_H

#include "Raster_judgement.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>

/// \file
/// The evidence for a cell in words and as JSON. Points of opposite sign and exact zeros are checked before they are
/// shown.
namespace corral::program {

/// How the subject of witnesses is called: f, or g where it is the square-free part of f.
template <std::size_t D>
[[nodiscard]] std::string evidence_text(const Evidence<D>& evidence,
                                        const std::vector<Polynomial<Rational, D>>& subjects,
                                        const std::array<std::string, D>& variables, const std::string& subject_name);

template <std::size_t D>
[[nodiscard]] nlohmann::ordered_json evidence_json(const Evidence<D>& evidence,
                                                   const std::vector<Polynomial<Rational, D>>& subjects,
                                                   const std::array<std::string, D>& variables);

} // namespace corral::program

#endif
