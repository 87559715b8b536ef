// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../decision/patient_step.h"
#include "Cell_search.h"
#include "Critical_prover.h"
#include "begun_certificate.h"
#include "guesses.h"
#include "validate.h"

#include <corral/certificate/certificate.h>
#include <corral/decision/ideal_system.h>
#include <corral/errors.h>
#include <corral/internal/localization/Subdivision.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace corral {
namespace {

using certificate::Box_forms;
using certificate::Cell_search;
using certificate::Critical_prover;
using certificate::Critical_record;
using certificate::Face;

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
  using Forms = Box_forms<D>;

  Certifier(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, const Run_options& run,
            const Certify_options& options)
      : run_(run), options_(options), cell_count_(grid.cell_count()), tree_(grid.resolution()),
        result_(certificate::begun_certificate(system, grid, work_)), checkpoint_([this] { require_going(); }),
        decide_(make_decider<D>(system, grid, checkpoint_of_steps()))
  {
    std::vector<Polynomial<Integer, D>> given;
    for (const auto& f : result_.polynomials) {
      given.push_back(f.square_free);
      proved_.push_back(f.proved());
    }
    if constexpr (D > 1) prover_.emplace(std::move(given), checkpoint_of_steps());
  }
  Certifier(const Certifier&) = delete; // the checkpoint points here
  Certifier& operator=(const Certifier&) = delete;

  Certificate<D> run() &&
  {
    const Node root = tree_.root();
    Rational_box<D> box;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational& lower = result_.grid.box()[axis].lower();
      box[axis] = Rational_interval(lower, lower + result_.grid.step(axis) * tree_.span(root.level, axis));
    }
    Forms forms;
    for (const auto& f : result_.polynomials) {
      forms.forms.push_back(certificate::counted_form(f.square_free, box, work_));
      forms.held += forms.forms.back().held();
    }
    visit(std::move(forms), root);
    if constexpr (D > 1) std::move(record_).write_to(result_);
    return std::move(result_);
  }

private:
  /// Whether to go on; once stopped, for good.
  bool goes_on()
  {
    if (run_.progress && !run_.stop.stop_requested()) run_.progress(static_cast<double>(settled_) / cell_count_);
    return !run_.stop.stop_requested();
  }

  void require_going()
  {
    if (!goes_on()) throw Cancelled("certificate: stopped on request");
  }

  /// What long steps call: in a thread of their own they must not ask the caller, nor refer to this object.
  [[nodiscard]] Checkpoint checkpoint_of_steps() const
  {
    if (!options_.patience) return checkpoint_;
    return [stop = run_.stop] {
      if (stop.stop_requested()) throw Cancelled("certificate: stopped on request");
    };
  }

  /// What the step gives. \param step  owns all that it refers to. \throw Cancelled if it does not end in time.
  template <class Step>
  [[nodiscard]] std::invoke_result_t<Step> run(Step step)
  {
    if (!options_.patience) return step();
    return exact::patient_step(
        std::move(step), [this] { return goes_on(); }, *options_.patience);
  }

  /// Whether a checker accepts a file to which so much is added, and the rest as unknown.
  [[nodiscard]] bool has_room(double more_work, double more_bytes, double more_values)
  {
    constexpr double max_bytes = 134217728; // half of what the format allows
    constexpr double max_values = 4194304;
    if (work_ + more_work > certificate::max_work
        || static_cast<double>(result_.tree.size()) + bytes_ + more_bytes > max_bytes
        || values_ + more_values > max_values)
      return false;
    work_ += more_work;
    bytes_ += more_bytes;
    values_ += more_values;
    return true;
  }

  void visit(Forms forms, const Node& node)
  {
    settled_ = result_.empty + result_.hit + result_.unknown;
    if (!goes_on()) return leave_unknown("stopped before it was decided", node);
    if (forms.held > certificate::max_branch_words || !has_room(forms.size(), 0, 0))
      return leave_unknown(too_large, node);
    if (forms.excludes_zero()) {
      result_.tree += 'e';
      result_.empty += cells(node);
    } else if (node.level == 0)
      visit_cell(forms, node);
    else {
      result_.tree += 's';
      forms.enter_children([&](std::size_t axis) { return tree_.halves(node.level, axis); });
      visit_children(std::move(forms), {node.level - 1, node.corner}, D);
    }
  }

  /// Visits the children in the order of their numbers: the last axis is halved first, so that it varies slowest.
  void visit_children(Forms forms, Node child, std::size_t axes)
  {
    if (axes == 0) return visit(std::move(forms), child);
    const std::size_t axis = axes - 1;
    if (!tree_.halves(child.level + 1, axis)) return visit_children(std::move(forms), child, axis);
    visit_children(forms.halve(axis, work_), child, axis);
    child.corner[axis] += tree_.span(child.level, axis);
    if (child.corner[axis] < result_.grid.resolution()[axis]) visit_children(std::move(forms), child, axis);
  }

  /// What costs too much leaves the cell unknown, and the others as they are.
  void visit_cell(const Forms& forms, const Node& node)
  {
    if (forms.forms.size() == 1 && exact::sign_pattern(forms.forms.front().form).crosses) {
      result_.tree += 'h';
      ++result_.hit;
      return;
    }
    try {
      decide_cell(forms, node);
    } catch (const Cancelled&) {
      leave_unknown("stopped before it was decided", node);
    } catch (const Budget_exceeded& error) {
      leave_unknown("not decided: " + std::string(error.what()), node);
    }
  }

  /// The cheap proofs first.
  void decide_cell(const Forms& forms, const Node& node)
  {
    constexpr std::size_t first_boxes = 64; // a cut or two prove most empty cells
    if (attempt(forms, first_boxes, node) || attempt_guesses(forms, node)) return;
    const auto decision = run([decide = decide_, cell = node.corner] { return decide(cell); });
    if (decision.verdict == Verdict::hit) return add_witness(decision.witness, node);
    if (attempt_critical(forms, node) || attempt(forms, options_.max_boxes, node)) return;
    leave_unknown(decision.verdict == Verdict::unknown ? "not decided: " + decision.reason
                                                       : "empty, but a proof would take more boxes than allowed",
                  node);
  }

  /// Tries what doubles say of zeros in the cell.
  bool attempt_guesses(const Forms& forms, const Node& node)
  {
    const auto cell = result_.grid.cell_box(node.corner);
    std::vector<Cell_proof<D>> guesses;
    if (forms.forms.size() == 1) {
      Sign_change<D> change;
      for (std::size_t axis = 0; axis < D; ++axis) change.first[axis] = cell[axis].lower();
      for (const auto& u : certificate::guess_other_sign(forms.forms.front())) {
        for (std::size_t axis = 0; axis < D; ++axis)
          change.second[axis] = cell[axis].lower() + result_.grid.step(axis) * u[axis];
        guesses.push_back(change);
      }
    } else if constexpr (D > 1) {
      for (auto& zero : certificate::guess_common_zeros(forms.forms, proved_, cell)) guesses.push_back(std::move(zero));
    }
    return std::any_of(guesses.begin(), guesses.end(), [&](const Cell_proof<D>& guess) {
      double work = 0;
      return certificate::is_acceptable(guess, proved_, cell, work) && add_proof(guess, work, node);
    });
  }

  /// Tries to prove the cell empty by cutting it; whether something was proved and written.
  bool attempt(const Forms& forms, std::size_t boxes, const Node& node)
  {
    using Outcome = typename Cell_search<D>::Outcome;
    Cell_search<D> search(boxes, forms.forms.size() == 1 ? sgn(forms.forms.front().form.corner(0)) : 0, checkpoint_);
    const Outcome outcome = search.run(forms);
    if (outcome == Outcome::gave_up) return false;
    if (outcome == Outcome::proved) {
      if (!has_room(search.work(), 0, 0)) return false;
      result_.tree += search.tree();
      ++result_.empty;
      return true;
    }
    const auto box = result_.grid.cell_box(node.corner);
    Rational_point<D> corner;
    Rational_point<D> other;
    for (std::size_t axis = 0; axis < D; ++axis) {
      corner[axis] = box[axis].lower();
      other[axis] = corner[axis] + result_.grid.step(axis) * search.zero()[axis];
    }
    add_witness(Sign_change<D>{search.changes() ? corner : other, other}, node);
    return true;
  }

  /// Tries to prove by critical multipliers that one of the polynomials has no zero in the cell.
  bool attempt_critical(const Forms& forms, const Node& node)
  {
    if constexpr (D > 1) {
      const std::size_t boxes = std::min(options_.max_boxes, std::size_t{1} << 14);
      for (std::size_t j = 0; j < forms.forms.size(); ++j) {
        Face<D> face{forms.forms[j], result_.grid.cell_box(node.corner), j, forms.held, forms.depth};
        auto [prover, part] = run([copy = *prover_, face = std::move(face), boxes]() mutable {
          auto found = copy.prove(std::move(face), boxes);
          return std::pair(std::move(copy), std::move(found));
        });
        prover_ = std::move(prover);
        if (!part) continue;
        const auto size = record_.size_of(*part, prover_->entries());
        if (!has_room(size.work, size.bytes, size.values)) continue;
        result_.tree += part->tree;
        ++result_.empty;
        record_.add(std::move(*part), prover_->entries());
        return true;
      }
    }
    return false;
  }

  void add_witness(const Witness<D>& witness, const Node& node)
  {
    const auto cell = result_.grid.cell_box(node.corner);
    std::optional<Cell_proof<D>> proof;
    if (const auto* change = std::get_if<Sign_change<D>>(&witness)) proof = *change;
    if (const auto* zero = std::get_if<Triangular_zero<D>>(&witness)) proof = *zero;
    double work = 0;
    if (!proof || !certificate::is_acceptable(*proof, proved_, cell, work))
      leave_unknown("hit, but the decision left no witness that the format can hold", node);
    else if (!add_proof(*proof, work, node))
      leave_unknown(too_large, node);
  }

  /// Writes an acceptable proof, if there is room for it.
  bool add_proof(const Cell_proof<D>& proof, double work, const Node& node)
  {
    double values = 12 + 4 * D;
    double word_count = 2 * values;
    if (const auto* zero = std::get_if<Triangular_zero<D>>(&proof))
      for (const auto& t : zero->chain) {
        values += (D + 2) * static_cast<double>(t.terms().size());
        word_count += static_cast<double>(t.terms().size()) * certificate::longest(t);
      }
    if (!has_room(work, certificate::digits_of_a_word * word_count + 8 * values, values)) return false;
    result_.tree += 'w';
    ++result_.hit;
    result_.witnesses.push_back({node.corner, proof});
    return true;
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

  static constexpr const char* too_large = "a proof would be beyond the limits of a checker";

  const Run_options& run_;
  const Certify_options& options_;
  double cell_count_;
  std::uint64_t settled_ = 0; ///< cells
  double work_ = 0;           ///< that a checker counts
  double bytes_ = 0;          ///< of the file, beside the tree
  double values_ = 0;         ///< of the file
  Subdivision_tree<D> tree_;
  Certificate<D> result_;
  Checkpoint checkpoint_;
  std::function<Cell_decision<D>(const Cell<D>&)> decide_;
  std::vector<Polynomial<Rational, D>> proved_{}; ///< those that the file's proofs are about
  std::optional<Critical_prover<(D > 1 ? D : 2)>> prover_{};
  Critical_record<(D > 1 ? D : 2)> record_{result_.polynomials.size()};
};

} // namespace

template <std::size_t D>
Certificate<D> certify(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, const Run_options& run,
                       const Certify_options& options)
{
  return Certifier<D>(system, grid, run, options).run();
}

template Certificate<1> certify(const std::vector<Polynomial<Rational, 1>>&, const Grid<1>&, const Run_options&,
                                const Certify_options&);
template Certificate<2> certify(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&, const Run_options&,
                                const Certify_options&);
template Certificate<3> certify(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&, const Run_options&,
                                const Certify_options&);

} // namespace corral
