#pragma once

namespace talus::gpu {

/// Turns on synchronous KHR_debug output for the current context. Messages of type ERROR or severity HIGH are
/// kept until the next raise_errors().
void watch_errors();

/// Throws talus::Error with the first message kept since the last call. Every wrapper of this room ends with
/// it. (The driver's callback itself may not throw: the exception would unwind the driver's own frames.)
void raise_errors();

/// Forgets the message kept: for failures that are reported with better words.
void forget_errors();

}  // namespace talus::gpu
