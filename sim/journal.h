#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sim/operation.h"

namespace talus {

/// How the terrain began, so that a replay can begin the same way.
struct JournalStart {
    std::string input;         ///< the file that was opened, empty where the terrain was generated
    std::string parameters;    ///< simulation parameters as TOML
    std::string import_guess;  ///< how the file was read, as the app's import settings write themselves
    std::uint64_t hash = 0;    ///< of the terrain before the first operation
    std::vector<std::string> ended_tables{};  ///< of the document, which ended at the start as their
                                              ///< parameters were set; by parameter
    std::string events{};                     ///< as they write themselves (sim/events.h)
};

/// The list of what was done since the start. Runs of ticks are one entry.
class Journal {
  public:
    void record(const Operation& operation);
    const std::vector<Operation>& operations() const { return operations_; }
    /// Rises with everything that changes the list.
    std::size_t revision() const { return revision_; }

    /// Where the journal stands, to come back to.
    struct Mark {
        std::size_t count = 0;
        Operation last = Ticks{0};  ///< ticks may be added to it later
    };
    Mark mark() const;
    /// Goes back to the mark and returns what it takes to come forward again.
    std::vector<Operation> cut(const Mark& mark);
    void restore(const Mark& mark, const std::vector<Operation>& tail);

  private:
    std::vector<Operation> operations_;
    std::size_t revision_ = 0;
};

/// A journal as text, a line of JSON an operation, the start first; and back. Throws talus::Error naming the
/// source and the line when it is not a journal.
std::string write_journal(const JournalStart& start, const Journal& journal);
struct JournalFile {
    JournalStart start;
    std::vector<Operation> operations;
};
JournalFile read_journal(const std::string& text, const std::string& source);

}  // namespace talus
