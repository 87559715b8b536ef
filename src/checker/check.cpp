// SPDX-License-Identifier: LGPL-3.0-or-later
#include "certificate.h"
#include "tree.h"

namespace corral_check {

struct Certificate::State : Contents
{
};

Certificate::Certificate(std::string bytes)
{
  auto state = std::make_unique<State>();
  read_contents(std::move(bytes), *state);
  state_ = std::move(state);
}

Certificate::Certificate(Certificate&&) noexcept = default;
Certificate& Certificate::operator=(Certificate&&) noexcept = default;
Certificate::~Certificate() = default;

const Claims& Certificate::claims() const { return state_->claims; }

void Certificate::check(const std::function<void(const Region&)>& visit) const
{
  const Counts counts = check_tree(*state_, visit);
  const Counts& claimed = state_->claims.counts;
  require(counts.empty == claimed.empty, {"empty"}, "is not the number of cells that the tree proves empty");
  require(counts.hit == claimed.hit, {"hit"}, "is not the number of cells that the tree proves hit");
  require(counts.unknown == claimed.unknown, {"unknown"}, "is not the number of cells left unknown");
}

Claims check(std::string bytes)
{
  const Certificate certificate(std::move(bytes));
  certificate.check();
  return certificate.claims();
}

} // namespace corral_check
