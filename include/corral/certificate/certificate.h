// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CERTIFICATE_CERTIFICATE_H
#define CORRAL_CERTIFICATE_CERTIFICATE_H

#include <corral/Run_options.h>
#include <corral/decision/Witness.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/localization/Grid.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// \file
/// Certificates: the verdict of every cell of a grid with its proof, as a file that a program which shares no code
/// with this library can check. The format is specified in doc/certificate.md; `corral-check` checks it.
namespace corral {

/// \brief A common zero of two polynomials by the theorem of Poincare and Miranda.
///
/// The combinations of the polynomials by the rows of the matrix have one strict sign each on one facet of the box and
/// the opposite one on the other, along the axes in which the box is not flat.
template <std::size_t D>
struct Miranda_zero
{
  Rational_box<D> box{};
  std::vector<std::vector<Rational>> matrix{};
};

/// What proves a zero in a cell, of the square-free parts.
template <std::size_t D>
using Cell_proof = std::variant<Sign_change<D>, Triangular_zero<D>, Miranda_zero<D>>;

/// A `hit` that the corners of its cell do not show, with what proves it of every polynomial.
template <std::size_t D>
struct Proved_cell
{
  Cell<D> cell{};
  Cell_proof<D> proof{};
};

/// A polynomial as given, and the one that the proofs are about.
template <std::size_t D>
struct Certified_polynomial
{
  Polynomial<Rational, D> given;
  Polynomial<Integer, D> square_free; ///< it has the same zeros
  unsigned power = 1;                 ///< `given` divides this power of `square_free`

  /// Whether `given` is its own square-free part, up to a factor.
  [[nodiscard]] bool is_square_free() const { return integer_primitive(given) == square_free; }
  /// The one that the file's proofs are about.
  [[nodiscard]] Polynomial<Rational, D> proved() const
  {
    return is_square_free() ? given : transform<Rational>(square_free, [](const Integer& c) { return Rational(c); });
  }
};

/// \brief a q + sum of b_k dq/dx_k, for some polynomial q, is a constant times the product of all factors with their
/// exponents: where q and those derivatives vanish, one of the factors does.
template <std::size_t D>
struct Multipliers
{
  std::size_t of = 0;                        ///< number of q: one of the input, or a factor of earlier multipliers
  Polynomial<Integer, D> a{};                ///< zero if there is none
  std::array<Polynomial<Integer, D>, D> b{}; ///< zero where there is none
  std::vector<std::pair<Polynomial<Integer, D>, unsigned>> factors{}; ///< not constant, with exponents
};

/// The proof of a box without zeros by critical multipliers (doc/certificate.md, section 6).
struct Critical_proof
{
  std::size_t multipliers = 0; ///< an index
  std::size_t axis = 0;        ///< along which a zero would be the first
  std::string trees{};         ///< of the facets and the factors
};

/// \brief What a file of proofs contains; doc/certificate.md gives the meaning of the parts.
template <std::size_t D>
struct Certificate
{
  std::vector<Certified_polynomial<D>> polynomials; ///< whose common zeros are asked for
  Grid<D> grid;                                     ///< the cells
  std::string tree{};                               ///< one character for each box
  std::vector<Proved_cell<D>> witnesses{};          ///< those that the tree refers to, in its order
  std::vector<Multipliers<D>> multipliers{};        ///< those that `critical` refers to
  std::vector<Critical_proof> critical{};           ///< those that the tree refers to, in its order
  std::vector<std::string> reasons{};               ///< why cells are unknown
  std::uint64_t empty = 0;                          ///< number of cells
  std::uint64_t hit = 0;                            ///< number of cells
  std::uint64_t unknown = 0;                        ///< number of cells

  [[nodiscard]] std::uint64_t plotted() const { return hit + unknown; }
};

/// How much to spend on a certificate.
struct Certify_options
{
  /// The number of boxes into which one cell may be cut to prove that it is empty.
  std::size_t max_boxes = std::size_t{1} << 16;
  /// How long a stop waits for a step of algebra that is under way, as in `Ideal_raster_options`: without a value until
  /// its end, with one it is left to a thread of its own, and its cell is unknown.
  std::optional<std::chrono::milliseconds> patience{};
};

/// \brief Decides every cell of the grid exactly and proves it.
///
/// Boxes without zeros are proved empty by Bernstein coefficients over integers, cells by the signs at their corners;
/// the few others by points and boxes that doubles have guessed, or they are decided by `Cell_decider` or
/// `System_decider` and proved by the witness, or near misses by critical multipliers. A decision that leaves
/// no witness which the format can hold is given up as unknown, with a reason, and so is what would cost too much:
/// nothing is written that a checker would refuse. When it is stopped the rest is unknown, and the reasons say so. It
/// works in one thread.
///
/// \param system  one polynomial, or in two and three dimensions two of them, whose common zeros are asked for.
/// \throw Invalid_input if a polynomial is zero, their number is not as above or the grid has 2^62 cells or more.
/// \throw Budget_exceeded if the degrees are above the limits of the format.
/// \throw Cancelled if it is stopped before the square-free parts are known.
/// \par Complexity  As for an ideal raster; n^2/2 additions of integers for each box and line of degree n.
template <std::size_t D>
[[nodiscard]] Certificate<D> certify(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                     const Run_options& run = {}, const Certify_options& options = {});

/// The same for one polynomial.
template <std::size_t D>
[[nodiscard]] Certificate<D> certify(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Run_options& run = {},
                                     const Certify_options& options = {})
{
  return certify(std::vector{f}, grid, run, options);
}

/// The certificate as JSON text. \throw Invalid_input if two variables have the same name.
template <std::size_t D>
[[nodiscard]] std::string to_json(const Certificate<D>& certificate, const std::array<std::string, D>& variables);

/// The gzip compression of some bytes; the same bytes give the same result.
[[nodiscard]] std::string gzip(std::string_view bytes);

} // namespace corral

#endif
