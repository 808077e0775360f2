#pragma once
// Ctrl-C: the work stops where it leaves nothing behind.

namespace mien::command {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, the first time; a second one ends the
/// process at once.
void watch_interrupts();

/// Whether one of them came.
bool interrupted();

/// Ends the process by the signal that came, so that shells stop their loops, too.
[[noreturn]] void die_of_interrupt();

}  // namespace mien::command
