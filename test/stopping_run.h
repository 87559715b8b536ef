// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_STOPPING_RUN_H
#define CORRAL_TEST_STOPPING_RUN_H

#include <corral/Run_options.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace corral::test {

/// A run that is asked to stop when it reports for the `report`-th time, and counts its reports. Copies of its options
/// share the count.
struct Stopping_run
{
  explicit Stopping_run(std::uint64_t report)
  {
    options.progress = [seen = reports, source = source, report](double) {
      if (++*seen >= report) source->request_stop();
    };
    options.stop = source->get_token();
  }
  std::shared_ptr<std::atomic<std::uint64_t>> reports = std::make_shared<std::atomic<std::uint64_t>>(0);
  std::shared_ptr<std::stop_source> source = std::make_shared<std::stop_source>();
  Run_options options{};
};

/// The options of a run that is asked to stop when it reports for the `report`-th time.
[[nodiscard]] inline Run_options stopping_at(std::uint64_t report) { return Stopping_run(report).options; }

} // namespace corral::test

#endif
