#pragma once
#include <string>
#include <vector>

#include "sim/gpu/barrier.h"
#include "sim/gpu/program_interface.h"

/// A book of what shaders stored and how it is used next: a use without the barrier for it throws, naming
/// both. Kept in debug builds, where TALUS_HAZARDS is set, and where a test turns it on; else every call here
/// returns at once.
namespace talus::gpu::hazards {

enum class Kind { texture, buffer };

/// Whether the book is kept from now on, on this thread.
void keep(bool on);
bool kept();
/// A context was made: its names begin anew.
void context_made();

/// An object was made: nothing is known of it but its label.
void made(Kind kind, unsigned name, const std::string& label);
/// Draws go into these textures from now on.
void bound_targets(const std::vector<unsigned>& textures);

/// A program is run or drawn with what is bound now. Throws talus::Error where a barrier is missing.
void run(const std::string& program, const std::vector<Place>& places);
/// A draw goes into the targets that are bound. Throws as run() does.
void draws(const std::string& program);
/// A call uses an object. Throws as run() does.
void used(Kind kind, unsigned name, Use use, const char* call);
/// What was stored before is there for this use.
void ordered(Use use);

}  // namespace talus::gpu::hazards
