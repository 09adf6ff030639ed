#pragma once

namespace talus::app {

/// The program: parses the command line, does what it says, prints errors as one sentence on stderr.
/// Returns the exit code: 0, 1 for what went wrong, 2 for a command line that cannot be understood.
int command_line(int argc, char** argv);

}  // namespace talus::app
