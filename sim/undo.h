#pragma once
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/book_copies.h"
#include "sim/journal.h"
#include "sim/moment.h"
#include "sim/packed_terrain.h"
#include "sim/terrain/terrain.h"
#include "sim/tile_changes.h"

namespace talus {

/// A simulation beside its layers, and where an act put another terrain in its place, with these.
struct Snapshot {
    BookCopies books;
    Moment moment;
    std::optional<PackedTerrain> terrain;
};

/// Undo and redo. An entry keeps the packed XOR delta of the tiles that an act changed. If the act replaced
/// the terrain, the entry keeps the whole old terrain, packed. Beyond the cap the oldest entries are dropped.
class Undo {
  public:
    /// Beyond this many bytes the oldest entries go.
    explicit Undo(std::size_t capacity_bytes) : capacity_bytes_(capacity_bytes) {}

    /// Opens an entry; what could be redone is dropped when it closes. No entry may be open. `parameter`: the
    /// one that it sets, if it does no more.
    void open(std::string name, Terrain& terrain, const Journal& journal, Snapshot before,
              std::string parameter = "");
    bool is_open() const { return open_; }
    void rename_open(std::string name) { done_.back().name = std::move(name); }
    /// True when the newest entry set this parameter and keeps no tiles, so that another change of it belongs
    /// to that entry, which has this name then; what could be redone is dropped.
    bool extends(const std::string& parameter, const std::string& name);
    std::size_t capacity() const { return capacity_bytes_; }
    void set_capacity(std::size_t bytes);
    /// Keeps these tiles as they are now, once per entry. Call before they change.
    void keep(Terrain& terrain, const std::vector<int>& tiles);
    void keep_all(Terrain& terrain);
    /// Keeps the whole terrain: another one takes its place. Nothing may have been kept in this entry so far.
    void keep_terrain(PackedTerrain before);
    /// Ends the open entry, if there is one. Tiles that did not change are let go; an entry during which
    /// nothing was recorded vanishes as if it had never been.
    void close(Terrain& terrain, const Journal& journal);
    /// Lets go of the open entry and of what it kept, without going back to it; what could be redone still
    /// can.
    void abandon();
    /// Moves on, without waiting, what is packed behind the acts' back. Once a frame.
    void poll();
    /// Waits for that.
    void settle();

    bool can_undo() const { return !done_.empty(); }
    bool can_redo() const { return !undone_.empty(); }
    const std::string& undo_name() const { return done_.back().name; }
    const std::string& redo_name() const { return undone_.back().name; }
    /// Names of the acts that can be undone, oldest first, and of those that can be redone, the next one
    /// first.
    std::vector<std::string> done() const;
    std::vector<std::string> undone() const;
    /// Whether nothing was recorded in the open entry so far.
    bool is_empty(const Journal& journal) const;
    /// Nothing can be redone any more.
    void forget_undone() { undone_.clear(); }
    /// What undo() or redo() would give back.
    const Snapshot& before() const { return done_.back().snapshot; }
    const Snapshot& after() const { return undone_.back().snapshot; }
    /// Restores the tiles that the act changed, and cuts or restores the journal. Returns the snapshot that
    /// the caller must restore: all other state, with the terrain if the act replaced it. `now`: the snapshot
    /// of the present state; it holds the present terrain exactly if the returned one holds a terrain.
    Snapshot undo(Terrain& terrain, Journal& journal, Snapshot now);
    Snapshot redo(Terrain& terrain, Journal& journal, Snapshot now);

    /// Memory of all closed entries; the newest one counts as it came until it is packed.
    std::size_t bytes() const;

  private:
    struct Entry {
        std::string name;
        std::string parameter;         // that it sets, if it does no more
        std::map<int, KeptTile> kept;  // as they were, while the entry is open
        TileChanges changes;           // of a closed one
        Snapshot snapshot;             // before the act; while undone, after it
        Journal::Mark mark;            // before the act
        std::vector<Operation> tail;   // of the journal, while undone
        std::size_t bytes() const;
    };
    void trim();

    std::size_t capacity_bytes_;
    bool open_ = false;
    bool all_kept_ = false;
    Tiles::Reader opened_at_;  // what changes later is the entry's
    std::deque<Entry> done_;
    std::vector<Entry> undone_;
    std::vector<Entry> dropped_;  // could be redone before the open entry
};

}  // namespace talus
