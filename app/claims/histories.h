#pragma once
#include <cstddef>
#include <cstdint>

namespace talus::claims {

/// A session with brushes, rain, erosion and parameters, told by the hash of its state.
struct HistoryFaults {
    int states = 0;       ///< that were told
    int undo = 0;         ///< states that undo did not lead back to
    int redo = 0;         ///< states that redo did not lead forth to
    bool replay = false;  ///< the journal, written and read, leads to another state
    bool reload = false;  ///< saved midway as a document, read and continued, it leads to another state
};
HistoryFaults history_faults();

/// Samples of water that differ, after so many seconds, where tiles at rest are skipped (law 2); and how many
/// of the tiles were active.
struct SkippedRest {
    std::size_t differing = 0;
    std::uint64_t active_tiles = 0;
    std::uint64_t all_tiles = 0;
};
SkippedRest skipped_rest(int order, bool driven, double seconds);

/// What the ledger misses after rain, erosion, slides, brushes and springs, relative to what moved: solid,
/// and water.
struct LedgerErrors {
    double solid = 0;
    double water = 0;
};
LedgerErrors ledger_errors();

/// Rain and inflow that follow tables, whose rows fall anywhere within ticks: what the ledger misses of the
/// tables' integrals, relative.
double table_error();

}  // namespace talus::claims
