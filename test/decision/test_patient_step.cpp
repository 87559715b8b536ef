// SPDX-License-Identifier: LGPL-3.0-or-later
#include "decision/patient_step.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

namespace {

using namespace corral;
using exact::patient_step;
constexpr auto moment = std::chrono::milliseconds(1);

TEST(Patient_step, gives_what_the_step_gives)
{
  EXPECT_EQ(patient_step([] { return 7; }, [] { return true; }, moment), 7);
  const auto fails = [] {
    return patient_step([]() -> int { throw std::runtime_error("of the step"); }, [] { return true; }, moment);
  };
  EXPECT_THROW((void)fails(), std::runtime_error);
}

// The step would never end, as far as the caller knows.
TEST(Patient_step, is_left_when_told_to_stop)
{
  const auto released = std::make_shared<std::atomic<bool>>(false);
  const auto ended = std::make_shared<std::atomic<bool>>(false);
  int left = 3;
  const auto waits = [released, ended] {
    while (!*released) std::this_thread::yield();
    *ended = true;
    return 0;
  };
  EXPECT_THROW((void)patient_step(
                   waits, [&] { return left-- > 0; }, moment),
               Cancelled);
  EXPECT_EQ(left, -1); // asked until it said so, and not again
  EXPECT_FALSE(*ended);
  *released = true;
  while (!*ended) std::this_thread::yield(); // it went on by itself, with what it owns
}

// A step that obeys while it is waited for is no reason to lose what it found.
TEST(Patient_step, is_waited_for)
{
  const auto stopped = std::make_shared<std::atomic<bool>>(false);
  const auto obeys = [stopped] {
    while (!*stopped) std::this_thread::yield();
    return 5;
  };
  const auto stop = [&] {
    *stopped = true;
    return false;
  };
  EXPECT_EQ(patient_step(obeys, stop, std::chrono::minutes(10)), 5);
}

} // namespace
