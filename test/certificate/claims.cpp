// SPDX-License-Identifier: LGPL-3.0-or-later
#include "claims.h"

#include <corral/decision/ideal_raster.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>

namespace certificate_test {
namespace {

using nlohmann::json;
using namespace corral;

struct Malformed
{
};

/// Reads the tree by recursion over boxes of cells: a larger number of cells than tests have is malformed.
class Tree_reader
{
public:
  Tree_reader(const std::string& tree, std::vector<std::uint64_t> resolution)
      : tree_(tree), resolution_(std::move(resolution))
  {
    std::uint64_t cells = 1;
    for (const auto n : resolution_) {
      if (n == 0 || n > 100000 || (cells *= n) > 100000) throw Malformed{};
      unsigned exponent = 0;
      while ((std::uint64_t{1} << exponent) < n) ++exponent;
      exponents_.push_back(exponent);
    }
    verdicts_.assign(cells, '?');
  }

  std::vector<char> read()
  {
    read_node(static_cast<int>(*std::max_element(exponents_.begin(), exponents_.end())),
              std::vector<std::uint64_t>(resolution_.size()));
    if (position_ != tree_.size()) throw Malformed{};
    return verdicts_;
  }

private:
  void read_node(int level, const std::vector<std::uint64_t>& corner)
  {
    if (position_ >= tree_.size() || level < -1000) throw Malformed{};
    const char read = tree_[position_++];
    const char symbol = read == 'c' ? 'e' : read; // another proof of the same
    if (symbol == 's') return read_children(level, corner);
    if (level < 0) {
      if (symbol != 'e') throw Malformed{};
      return;
    }
    if (symbol == 'e' || (symbol >= '0' && symbol <= '9')) return fill(level, corner, symbol == 'e' ? 'e' : 'u');
    if (level != 0 || (symbol != 'h' && symbol != 'w')) throw Malformed{};
    fill(level, corner, 'h');
  }

  void read_children(int level, const std::vector<std::uint64_t>& corner)
  {
    if (level == 0) fill(0, corner, 'e');
    for (unsigned child = 0; child < 1U << corner.size(); ++child) {
      auto place = corner;
      bool exists = true;
      for (std::size_t axis = 0; axis < corner.size() && level >= 1; ++axis)
        if ((child >> axis & 1) != 0) {
          place[axis] += std::uint64_t{1} << (level - 1);
          exists = exists && level <= static_cast<int>(exponents_[axis]) && place[axis] < resolution_[axis];
        }
      if (exists) read_node(level - 1, place);
    }
  }

  void fill(int level, const std::vector<std::uint64_t>& corner, char verdict)
  {
    auto cell = corner;
    const auto end = [&](std::size_t axis) {
      const auto span = std::uint64_t{1} << std::min(level, static_cast<int>(exponents_[axis]));
      return std::min(resolution_[axis], corner[axis] + span);
    };
    while (true) {
      std::uint64_t index = 0;
      for (std::size_t axis = 0; axis < cell.size(); ++axis) index = index * resolution_[axis] + cell[axis];
      verdicts_.at(index) = verdict;
      std::size_t axis = 0;
      while (axis < cell.size() && ++cell[axis] == end(axis)) {
        cell[axis] = corner[axis];
        ++axis;
      }
      if (axis == cell.size()) return;
    }
  }

  const std::string& tree_;
  std::vector<std::uint64_t> resolution_;
  std::vector<unsigned> exponents_;
  std::vector<char> verdicts_;
  std::size_t position_ = 0;
};

template <std::size_t D>
Polynomial<Rational, D> polynomial(const json& value)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (const json& term : value) {
    Exponents<D> exponents;
    for (std::size_t axis = 0; axis < D; ++axis) exponents[axis] = term.at(axis + 1).get<std::uint16_t>();
    terms.push_back({exponents, Rational(term.at(0).get<std::string>())});
  }
  return collect<Rational, D>(std::move(terms));
}

template <std::size_t D>
bool are_true(const Claims& claims, bool same_subject, const std::vector<char>& known)
{
  Rational_box<D> box;
  Resolution<D> resolution;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box[axis] = Rational_interval(Rational(claims.box[axis][0].get<std::string>()),
                                  Rational(claims.box[axis][1].get<std::string>()));
    resolution[axis] = static_cast<std::uint32_t>(claims.resolution[axis]);
  }
  auto f = polynomial<D>(claims.polynomials[0]);
  if (claims.polynomials.size() > 1) f = f * f;
  for (std::size_t j = 1; j < claims.polynomials.size(); ++j) {
    const auto next = polynomial<D>(claims.polynomials[j]);
    f = f + next * next;
  }
  std::optional<Cell_decider<D>> decider;
  for (std::uint64_t index = 0; index < claims.verdicts.size(); ++index) {
    const char verdict = claims.verdicts[index];
    if (verdict == 'u' || (same_subject && known[index] == verdict)) continue;
    if (!decider) decider.emplace(f, Grid<D>(box, resolution));
    Cell<D> cell;
    std::uint64_t rest = index;
    for (std::size_t axis = D; axis-- > 0; rest /= resolution[axis])
      cell[axis] = static_cast<std::uint32_t>(rest % resolution[axis]);
    const auto truth = decider->decide(cell).verdict;
    if (truth != (verdict == 'e' ? Verdict::empty : Verdict::hit)) return false;
  }
  return true;
}

} // namespace

std::optional<Claims> read_claims(const std::string& text)
{
  try {
    const json root = json::parse(text);
    Claims claims{root.at("polynomials"), root.at("box"), root.at("resolution").get<std::vector<std::uint64_t>>(), {}};
    if (claims.resolution.size() != root.at("dimension").get<std::size_t>() || claims.resolution.empty()) return {};
    claims.verdicts = Tree_reader(root.at("tree").get_ref<const std::string&>(), claims.resolution).read();
    const auto count = [&](char verdict) {
      return std::count(claims.verdicts.begin(), claims.verdicts.end(), verdict);
    };
    if (root.at("empty") != count('e') || root.at("hit") != count('h') || root.at("unknown") != count('u')) return {};
    return claims;
  } catch (const json::exception&) {
    return {};
  } catch (const Malformed&) {
    return {};
  }
}

bool are_true(const Claims& claims, const Claims& known)
{
  const bool same_subject =
      claims.polynomials == known.polynomials && claims.box == known.box && claims.resolution == known.resolution;
  switch (claims.resolution.size()) {
  case 1:
    return are_true<1>(claims, same_subject, known.verdicts);
  case 2:
    return are_true<2>(claims, same_subject, known.verdicts);
  default:
    return are_true<3>(claims, same_subject, known.verdicts);
  }
}

} // namespace certificate_test
