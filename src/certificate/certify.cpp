// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../algebra/Bernstein_form.h"
#include "validate.h"

#include <corral/certificate/certificate.h>
#include <corral/decision/ideal_system.h>
#include <corral/localization/Subdivision.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/square_free.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace corral {
namespace {

using exact::Bernstein_form;

template <std::size_t D>
void require_limits(const Polynomial<Rational, D>& f, const char* what)
{
  double dense = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    dense *= f.degree(axis) + 1;
    if (f.degree(axis) > 1000)
      throw Budget_exceeded("certificate: " + std::string(what) + " has the degree " + std::to_string(f.degree(axis))
                            + " in one variable; expected at most 1000");
  }
  if (dense > 65536)
    throw Budget_exceeded("certificate: " + std::string(what)
                          + " has too high a degree; expected (degree + 1) of all variables multiplied to be at most "
                            "65536");
}

template <std::size_t D>
Certificate<D> start(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid)
{
  constexpr double max_cells = 4611686018427387904.0; // 2^62
  if (grid.cell_count() >= max_cells)
    throw Invalid_input("certificate: the grid has 2^62 cells or more; expected fewer");
  if (system.empty() || system.size() > (D == 1 ? 1U : 2U))
    throw Invalid_input("certificate: given " + detail::quantity(system.size(), "polynomial") + " in "
                        + detail::quantity(D, "dimension") + "; expected 1, or 2 in two or three dimensions");
  Certificate<D> result{{}, grid};
  for (const auto& f : system) {
    if (f.is_zero())
      throw Invalid_input("certificate: a polynomial is zero, so that every point is a zero; expected one that is not");
    require_limits(f, "the polynomial");
    Certified_polynomial<D> entry{f, square_free_part(f)};
    if (integer_primitive(f) != entry.square_free) entry.power = certificate::highest_multiplicity(f);
    result.polynomials.push_back(std::move(entry));
  }
  return result;
}

/// What decides a cell when its signs do not.
template <std::size_t D>
std::function<Cell_decision<D>(const Cell<D>&)> make_decider(const std::vector<Polynomial<Rational, D>>& system,
                                                             const Grid<D>& grid, const Checkpoint& checkpoint)
{
  if constexpr (D > 1)
    if (system.size() > 1) {
      const auto decider = std::make_shared<System_decider<D>>(system, grid, checkpoint);
      return [decider](const Cell<D>& cell) { return decider->decide(cell); };
    }
  const auto decider = std::make_shared<Cell_decider<D>>(system.front(), grid, checkpoint);
  return [decider](const Cell<D>& cell) { return decider->decide(cell); };
}

/// Walks the subdivision tree depth first and writes down what it proves.
template <std::size_t D>
class Certifier
{
public:
  using Node = Subdivision_node<D>;
  using Forms = std::vector<Bernstein_form<D>>; // one for each polynomial

  Certifier(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, const Certify_options& options)
      : options_(options), cell_count_(grid.cell_count()), tree_(grid.resolution()), result_(start(system, grid)),
        decide_(make_decider<D>(system, grid, [this] { require_going(); }))
  {
    for (const auto& f : result_.polynomials)
      rational_.push_back(transform<Rational>(f.square_free, [](const Integer& c) { return Rational(c); }));
  }
  Certifier(const Certifier&) = delete; // the checkpoint points here
  Certifier& operator=(const Certifier&) = delete;

  Certificate<D> run() &&
  {
    const Node root = tree_.root();
    std::array<Rational, D> offset;
    std::array<Rational, D> scale;
    for (std::size_t axis = 0; axis < D; ++axis) {
      offset[axis] = result_.grid.box()[axis].lower();
      scale[axis] = result_.grid.step(axis) * tree_.span(root.level, axis);
    }
    Forms forms;
    for (const auto& f : rational_) {
      auto& form =
          forms.emplace_back(exact::dense_power_form(integer_primitive(affine_substitution(f, offset, scale))));
      exact::to_bernstein(form);
      exact::drop_twos(form);
    }
    visit(std::move(forms), root);
    return std::move(result_);
  }

private:
  /// What an attempt to prove a cell empty came to.
  enum class Attempt { proved, zero, gave_up };

  /// A box inside a cell: [index, index + 1] / 2^depth along each axis of the cell.
  struct Piece
  {
    Forms forms;
    std::array<Integer, D> index{};
    unsigned depth = 0;
  };

  /// A search below one cell.
  struct Search
  {
    std::size_t boxes_left;
    int sign; ///< that of one polynomial at all corners of the cell; 0 for a system
    std::string tree{};
    Rational_point<D> zero{}; ///< in the cell's own coordinates: a common zero, or
    bool changes = false;     ///< a point where the one polynomial has another sign than at the first corner
  };

  /// Whether to go on; once stopped, for good.
  bool goes_on()
  {
    if (!stopped_ && options_.progress) {
      stopped_ = !options_.progress(static_cast<double>(settled_) / cell_count_);
    }
    return !stopped_;
  }

  void require_going()
  {
    if (!goes_on()) throw Cancelled("certificate: stopped by the caller");
  }

  void visit(Forms forms, const Node& node)
  {
    settled_ = result_.empty + result_.hit + result_.unknown;
    if (!goes_on()) return leave_unknown("stopped before it was decided", node);
    if (excludes_zero(forms)) {
      result_.tree += 'e';
      result_.empty += cells(node);
    } else if (node.level == 0)
      visit_cell(forms, node);
    else {
      result_.tree += 's';
      visit_children(std::move(forms), {node.level - 1, node.corner}, D);
    }
  }

  /// Whether the coefficients of one polynomial keep away from zero.
  static bool excludes_zero(const Forms& forms)
  {
    return std::any_of(forms.begin(), forms.end(),
                       [](const Bernstein_form<D>& form) { return exact::sign_pattern(form).closed() != 0; });
  }

  /// The lower halves; the upper ones are left in `forms`.
  static Forms halve(Forms& forms, std::size_t axis)
  {
    Forms lower;
    for (auto& form : forms) lower.push_back(exact::halve(form, axis));
    return lower;
  }

  /// Visits the children in the order of their numbers: the last axis is halved first, so that it varies slowest.
  void visit_children(Forms forms, Node child, std::size_t axes)
  {
    if (axes == 0) return visit(std::move(forms), child);
    const std::size_t axis = axes - 1;
    if (!tree_.halves(child.level + 1, axis)) return visit_children(std::move(forms), child, axis);
    visit_children(halve(forms, axis), child, axis);
    child.corner[axis] += tree_.span(child.level, axis);
    if (child.corner[axis] < result_.grid.resolution()[axis]) visit_children(std::move(forms), child, axis);
  }

  void visit_cell(const Forms& forms, const Node& node)
  {
    if (forms.size() == 1 && exact::sign_pattern(forms.front()).crosses) {
      result_.tree += 'h';
      ++result_.hit;
      return;
    }
    constexpr std::size_t first_boxes = 64; // a cut or two prove most empty cells
    try {
      if (attempt(forms, first_boxes, node)) return;
      const auto decision = decide_(node.corner);
      if (decision.verdict == Verdict::unknown) return leave_unknown("not decided: " + decision.reason, node);
      if (decision.verdict == Verdict::hit) return add_witness(decision.witness, node);
      if (!attempt(forms, options_.max_boxes, node))
        leave_unknown("empty, but a proof would take more boxes than allowed", node);
    } catch (const Cancelled&) {
      leave_unknown("stopped before it was decided", node);
    }
  }

  /// Tries to prove the cell empty by cutting it; whether something was proved and written.
  bool attempt(const Forms& forms, std::size_t boxes, const Node& node)
  {
    Search search{boxes, forms.size() == 1 ? sgn(forms.front().corner(0)) : 0};
    const Attempt outcome = search_piece({forms, {}, 0}, search);
    if (outcome == Attempt::gave_up) return false;
    if (outcome == Attempt::proved) {
      result_.tree += search.tree;
      ++result_.empty;
      return true;
    }
    const auto box = result_.grid.cell_box(node.corner);
    Rational_point<D> corner;
    Rational_point<D> other;
    for (std::size_t axis = 0; axis < D; ++axis) {
      corner[axis] = box[axis].lower();
      other[axis] = corner[axis] + result_.grid.step(axis) * search.zero[axis];
    }
    add_witness(Sign_change<D>{search.changes ? corner : other, other}, node);
    return true;
  }

  Attempt search_piece(Piece piece, Search& search)
  {
    constexpr unsigned max_depth = 400;
    if (excludes_zero(piece.forms)) {
      search.tree += 'e';
      return Attempt::proved;
    }
    for (unsigned corner = 0; corner < 1U << D; ++corner)
      if (const auto changes = shows_zero(piece.forms, corner, search.sign)) {
        for (std::size_t axis = 0; axis < D; ++axis) {
          search.zero[axis] = Rational(piece.index[axis] + (corner >> axis & 1), Integer(Integer(1) << piece.depth));
          search.zero[axis].canonicalize();
        }
        search.changes = *changes;
        return Attempt::zero;
      }
    if (search.boxes_left < (1U << D) || piece.depth == max_depth) return Attempt::gave_up;
    search.boxes_left -= 1U << D;
    search.tree += 's';
    ++piece.depth;
    for (Integer& i : piece.index) i *= 2;
    return search_children(std::move(piece), search, D);
  }

  Attempt search_children(Piece piece, Search& search, std::size_t axes)
  {
    if (axes == 0) {
      require_going();
      return search_piece(std::move(piece), search);
    }
    const std::size_t axis = axes - 1;
    Piece lower{halve(piece.forms, axis), piece.index, piece.depth};
    ++piece.index[axis];
    const Attempt first = search_children(std::move(lower), search, axis);
    return first == Attempt::proved ? search_children(std::move(piece), search, axis) : first;
  }

  /// Whether a corner shows a zero: by a change of sign (then `true`), or since it is one itself (`false`).
  static std::optional<bool> shows_zero(const Forms& forms, unsigned corner, int sign)
  {
    const auto vanishes = [&](const Bernstein_form<D>& form) { return form.corner(corner) == 0; };
    if (std::all_of(forms.begin(), forms.end(), vanishes)) return false;
    if (sign != 0 && sgn(forms.front().corner(corner)) != sign) return true;
    return std::nullopt;
  }

  void add_witness(const Witness<D>& witness, const Node& node)
  {
    const auto cell = result_.grid.cell_box(node.corner);
    const auto proved = [&](const Polynomial<Rational, D>& g) { return certificate::is_acceptable(witness, g, cell); };
    const auto* change = std::get_if<Sign_change<D>>(&witness);
    const bool is_of_one_only = change != nullptr && change->first != change->second;
    if ((is_of_one_only && rational_.size() > 1) || !std::all_of(rational_.begin(), rational_.end(), proved))
      return leave_unknown("hit, but the decision left no witness that the format can hold", node);
    result_.tree += 'w';
    ++result_.hit;
    result_.witnesses.push_back({node.corner, witness});
  }

  void leave_unknown(const std::string& reason, const Node& node)
  {
    constexpr std::size_t max_reasons = 10;
    auto& reasons = result_.reasons;
    auto found = std::find(reasons.begin(), reasons.end(), reason);
    if (found == reasons.end() && reasons.size() < max_reasons) found = reasons.insert(found, reason);
    if (found == reasons.end()) *--found = "several other reasons";
    result_.tree += static_cast<char>('0' + (found - reasons.begin()));
    result_.unknown += cells(node);
  }

  [[nodiscard]] std::uint64_t cells(const Node& node) const
  {
    std::uint64_t product = 1;
    for (std::size_t axis = 0; axis < D; ++axis) product *= tree_.end(node, axis) - node.corner[axis];
    return product;
  }

  const Certify_options& options_;
  double cell_count_;
  std::uint64_t settled_ = 0; ///< cells
  bool stopped_ = false;
  Subdivision_tree<D> tree_;
  Certificate<D> result_;
  std::function<Cell_decision<D>(const Cell<D>&)> decide_;
  std::vector<Polynomial<Rational, D>> rational_{}; ///< the square-free parts
};

} // namespace

template <std::size_t D>
Certificate<D> certify(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                       const Certify_options& options)
{
  return Certifier<D>(system, grid, options).run();
}

template Certificate<1> certify(const std::vector<Polynomial<Rational, 1>>&, const Grid<1>&, const Certify_options&);
template Certificate<2> certify(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&, const Certify_options&);
template Certificate<3> certify(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&, const Certify_options&);

} // namespace corral
