// SPDX-License-Identifier: LGPL-3.0-or-later
#include "stopping.h"

#include <corral/output/Output_file.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <flint/flint.h>
#include <gmp.h>
#include <sys/time.h>
#include <unistd.h>

namespace corral::program {

namespace {

// All that a handler of signals reads or writes.
volatile std::sig_atomic_t caught = 0;
volatile std::sig_atomic_t has_bar = 0;
std::atomic<const char*> last_words{"corral: interrupted; nothing was written\n"};
static_assert(std::atomic<const char*>::is_always_lock_free);

void say(const char* words)
{
  if (has_bar != 0 && ::write(STDERR_FILENO, "\r\033[K", 4) < 0) return;
  if (words != nullptr && ::write(STDERR_FILENO, words, std::strlen(words)) < 0) return;
}

[[noreturn]] void end_at_once(int code, const char* words)
{
  remove_unfinished_files();
  say(words);
  ::_exit(code);
}

void set_timer(long microseconds)
{
  itimerval timer = {};
  timer.it_value.tv_usec = microseconds;
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

extern "C" void time_is_up(int) { end_at_once(128 + caught, last_words); }

extern "C" void ask_to_stop(int signal)
{
  if (caught != 0) end_at_once(128 + signal, last_words);
  caught = signal;
  constexpr long patience = 800'000;
  set_timer(patience);
}

void handle(int signal, void (*handler)(int))
{
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

template <class Pointer>
Pointer* checked(Pointer* memory)
{
  if (memory == nullptr) end_at_once(EXIT_FAILURE, "corral: out of memory\n");
  return memory;
}

// malloc may return a null pointer for nothing at all.
std::size_t at_least_one(std::size_t size) { return size == 0 ? 1 : size; }

extern "C" void* allocate(std::size_t size) { return checked(std::malloc(at_least_one(size))); }
extern "C" void* allocate_zeros(std::size_t count, std::size_t size)
{
  return checked(std::calloc(at_least_one(count), at_least_one(size)));
}
extern "C" void* reallocate(void* memory, std::size_t size)
{
  return checked(std::realloc(memory, at_least_one(size)));
}
extern "C" void* reallocate_known(void* memory, std::size_t, std::size_t size) { return reallocate(memory, size); }
extern "C" void release_known(void* memory, std::size_t) { std::free(memory); }
extern "C" void release(void* memory) { std::free(memory); }

} // namespace

void install_signal_handlers()
{
  handle(SIGALRM, time_is_up);
  handle(SIGINT, ask_to_stop);
  handle(SIGTERM, ask_to_stop);
  struct sigaction hangup = {};
  ::sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) handle(SIGHUP, ask_to_stop); // nohup ignores it
  std::signal(SIGXFSZ, SIG_IGN); // so that a write beyond the limit fails and is reported
}

void install_memory_functions()
{
  mp_set_memory_functions(allocate, reallocate_known, release_known);
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, release);
}

int interrupted_by() { return caught; }

void keep_what_is_proved()
{
  set_timer(0);
  last_words = "corral: interrupted twice; nothing was written\n";
}

void files_are_written() { last_words = "corral: interrupted; files are written, standard output is not whole\n"; }

void say_no_more() { last_words = nullptr; }

void bar_is_shown(bool shown) { has_bar = shown ? 1 : 0; }

} // namespace corral::program
