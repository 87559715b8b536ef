// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_PATIENT_STEP_H
#define CORRAL_SRC_DECISION_PATIENT_STEP_H

#include <corral/errors.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

namespace corral::exact {

/// \brief What `step()` gives, computed by a thread of its own, so that a step which cannot be asked to stop is no
/// reason to wait.
/// \param step  refers to nothing but what it owns: where it does not end in time it is left to itself.
/// \param goes_on  asked now and then by the caller's thread; once `false`, the step has `patience` to end.
/// \throw Cancelled if it is left; what the step throws.
template <class Step, class Ask>
[[nodiscard]] std::invoke_result_t<Step> patient_step(Step step, const Ask& goes_on, std::chrono::milliseconds patience)
{
  constexpr auto moment = std::chrono::milliseconds(5);
  struct Shared
  {
    std::mutex mutex;
    std::condition_variable is_done;
    std::optional<std::invoke_result_t<Step>> result;
    std::exception_ptr failure;
    [[nodiscard]] bool done() const { return result || failure; }
  };
  const auto shared = std::make_shared<Shared>();
  std::thread worker([shared, step = std::move(step)]() mutable {
    std::optional<std::invoke_result_t<Step>> result;
    std::exception_ptr failure;
    try {
      result = step();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(shared->mutex);
    shared->result = std::move(result);
    shared->failure = failure;
    shared->is_done.notify_all();
  });
  std::unique_lock lock(shared->mutex);
  const auto is_done = [&] { return shared->done(); };
  while (!shared->is_done.wait_for(lock, moment, is_done)) {
    if (goes_on()) continue;
    if (shared->is_done.wait_for(lock, patience, is_done)) break;
    worker.detach();
    throw Cancelled("exact decision: a step did not end in time and was left");
  }
  lock.unlock();
  worker.join();
  if (shared->failure) std::rethrow_exception(shared->failure);
  return std::move(*shared->result);
}

} // namespace corral::exact

#endif
