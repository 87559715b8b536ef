// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_RUN_OPTIONS_H
#define CORRAL_RUN_OPTIONS_H

#include <corral/errors.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

namespace corral {

/// \brief How any algorithm of the library runs. No result depends on `threads` or `progress`.
///
/// One rule for all that are stopped: what is proved by then is kept, the result says that it was stopped, and what was
/// not looked at is `unknown` (of a mesh: uncertified). Only an answer that is whole or worthless, such as all zeros of
/// a system, is given up by throwing `Cancelled`; its function says so.
struct Run_options
{
  unsigned threads = 1; ///< 0: one for each processor. An algorithm that works in one thread uses one
  /// Most cells that a result may hold, or that are looked at. Without a value the algorithm's own default.
  std::optional<std::uint64_t> cell_budget{};
  /// Called now and then, from one thread at a time, with the share done (0 to 1; 0 where nobody can tell).
  std::function<void(double)> progress{};
  /// Asks to stop. Obeyed as soon as the current step ends, even if the progress callback has asked for it.
  std::stop_token stop{};

  /// Whether anybody looks on or may ask to stop.
  [[nodiscard]] bool is_watched() const { return progress || stop.stop_possible(); }
};

namespace detail {

/// Tells what share is done. \throw Cancelled in the name of `who` if a stop is asked for.
inline void report_or_throw(const Run_options& run, double done, const char* who)
{
  if (run.progress) run.progress(done);
  if (run.stop.stop_requested()) throw Cancelled(std::string(who) + ": stopped on request");
}

} // namespace detail

} // namespace corral

#endif
