// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_AUDIT_CASES_H
#define CORRAL_AUDIT_AUDIT_CASES_H

#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Polynomials, boxes and exact values on which faults show; doc/audit.md says how they are biased and why. The
/// functions are compiled for D = 1 to 4.
namespace corral {

/// A box, and the least and the greatest value that a polynomial takes at some of its points, exactly.
template <std::size_t D>
struct Probed_box
{
  Rational_box<D> box;
  Rational_point<D> lowest; ///< where the least value is taken
  Rational_point<D> highest;
  Rational least;
  Rational greatest;
  std::uint64_t points = 0; ///< how many points were looked at
};

/// One polynomial and the boxes to bound it on, in this order and by one object.
template <std::size_t D>
struct Audit_case
{
  Polynomial<Rational, D> polynomial;
  std::vector<Probed_box<D>> boxes;
};

/// A polynomial to audit bounders on, and the box and grid where it is used.
template <std::size_t D>
struct Audit_subject
{
  Polynomial<Rational, D> polynomial;
  Rational_box<D> domain;
  unsigned resolution = 256; ///< cells along each axis; a power of two gives the boxes of subdivision
};

/// \brief The generated case of this number: a polynomial biased to trouble, with several boxes.
///
/// A case depends on the seed and its number alone.
template <std::size_t D>
[[nodiscard]] Audit_case<D> generated_case(std::uint64_t seed, std::uint64_t number);

/// The case of this number of a given polynomial: blocks and cells of its grid, all levels of subdivision.
template <std::size_t D>
[[nodiscard]] Audit_case<D> subject_case(const Audit_subject<D>& subject, std::uint64_t seed, std::uint64_t number);

/// \brief The case of this number for tightness: a polynomial of moderate coefficients and one box of any width from
/// 2 to 2^-12.
template <std::size_t D>
[[nodiscard]] Audit_case<D> tightness_case(std::uint64_t seed, std::uint64_t number);

/// `[a, b] x [c, d]`, exactly.
template <std::size_t D>
[[nodiscard]] std::string to_string(const Rational_box<D>& box);

/// The polynomial in the variables x, y, z, w, exactly; `parse_polynomial` gives it back.
template <std::size_t D>
[[nodiscard]] std::string to_string(const Polynomial<Rational, D>& f);

} // namespace corral

#endif
