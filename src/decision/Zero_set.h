// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_ZERO_SET_H
#define CORRAL_SRC_DECISION_ZERO_SET_H

#include "../algebra/Bernstein_form.h"
#include "../algebra/Plane_system.h"

#include <corral/decision/Cell_decision.h>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace corral::exact {

class Inner_pieces;

/// \brief The zero set of one polynomial, asked of closed boxes whether they meet it. Proof: doc/exact.md.
///
/// What is costly to know (restrictions to the planes of facets, resultants) is computed when first needed and kept.
template <std::size_t D>
class Zero_set
{
public:
  using Source = std::function<Polynomial<Integer, D>()>;

  /// `source` gives the polynomial; it is called at most once, and only if signs of coefficients do not suffice.
  Zero_set(Source source, Checkpoint checkpoint, Witnesses witnesses);
  ~Zero_set();

  /// \brief Decides a closed box.
  /// \param form  the polynomial on `box`, times a positive number.
  [[nodiscard]] Cell_decision<D> decide(const Bernstein_form<D>& form, const Rational_box<D>& box);

  /// Whether it was seen that there is no real zero at all.
  [[nodiscard]] bool is_known_definite() const { return definite_.value_or(false); }

  /// Whether the polynomial has its least values on the boundary of every box.
  [[nodiscard]] bool boundary_suffices();

private:
  static constexpr std::size_t lower_dimension = D > 1 ? D - 1 : 1;

  struct Piece
  {
    Bernstein_form<D> form;
    std::array<Integer, D> index{};
  };
  struct Search // of the interior of a box for pieces of the zero set
  {
    Rational_box<D> box;
    int sign = 0; ///< of the polynomial at the corners; the whole boundary has it
    std::vector<Piece> live;
    unsigned depth = 0;
  };

  [[nodiscard]] const Polynomial<Integer, D>& polynomial();
  [[nodiscard]] bool is_definite();
  [[nodiscard]] std::optional<Cell_decision<D>> zero_on_facets(const Bernstein_form<D>& form,
                                                               const Rational_box<D>& box);
  [[nodiscard]] std::optional<Cell_decision<D>> zero_in_section(const Bernstein_form<lower_dimension>& form,
                                                                std::size_t axis, const Rational& value,
                                                                const Rational_box<D>& box);
  [[nodiscard]] std::optional<Cell_decision<D>> zero_in_middle(const Search& search);
  [[nodiscard]] std::optional<Cell_decision<D>> subdivide(Search& search, unsigned max_depth, std::size_t max_live);
  [[nodiscard]] std::optional<Cell_decision<D>> keep_or_decide(Search& search, Piece piece, std::vector<Piece>& kept);
  [[nodiscard]] std::optional<Cell_decision<D>> guess(const Search& search);
  [[nodiscard]] Cell_decision<D> decide_by_algebra(Search& search);
  [[nodiscard]] Rational_box<D> piece_box(const Search& search, const Piece& piece) const;

  Source source_;
  Checkpoint checkpoint_;
  Witnesses witnesses_;
  std::optional<Polynomial<Integer, D>> polynomial_;
  std::optional<bool> definite_;
  std::optional<bool> has_constant_slope_;
  std::map<std::pair<std::size_t, Rational>, std::unique_ptr<Zero_set<lower_dimension>>> restrictions_;
  std::unique_ptr<Plane_system> extremes_; ///< D = 2: g and its derivative by y
  std::unique_ptr<Inner_pieces> pieces_;   ///< D = 3: strictly inside a box
};

} // namespace corral::exact

#endif
