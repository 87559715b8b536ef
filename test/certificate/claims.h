// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_CERTIFICATE_CLAIMS_H
#define CORRAL_TEST_CERTIFICATE_CLAIMS_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// \file
/// What a certificate claims, read without looking at its proofs, and whether that is true. Written for the test of
/// mutations, from doc/certificate.md; it shares no code with either checker.
namespace certificate_test {

/// The claims: of which polynomials, on which grid, which verdict each cell has.
struct Claims
{
  nlohmann::json polynomials;
  nlohmann::json box;
  std::vector<std::uint64_t> resolution;
  std::vector<char> verdicts; ///< 'e', 'h' or 'u' for each cell, the last axis running fastest
};

/// \brief The claims of a file, or nothing if it makes none: it is not JSON, lacks a part, its tree does not cover the
/// grid once, or its counts contradict its tree.
[[nodiscard]] std::optional<Claims> read_claims(const std::string& text);

/// \brief Whether all claims are true, by the exact decision of every cell on which they differ from `known`, which is
/// known to be true. Several polynomials are decided by the sum of their squares.
[[nodiscard]] bool are_true(const Claims& claims, const Claims& known);

} // namespace certificate_test

#endif
