#pragma once
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/journal.h"
#include "sim/ledger.h"
#include "sim/packed_terrain.h"
#include "sim/parameters.h"
#include "sim/terrain/terrain.h"
#include "sim/tile_changes.h"

namespace talus {

/// What undo restores besides the layers.
struct Moment {
    Clock clock;
    Parameters parameters;
    std::vector<Spring> springs;
    double edges_since_s = 0;
    double sea_m3 = 0;     ///< water that sea levels brought so far
    double booked_m3 = 0;  ///< solid that changes of porosity and acceleration, and blurs, brought so far
    LedgerStart ledger;    ///< what it counts from
    std::optional<Georeference> georeference;
    std::shared_ptr<const Stamp> stamp;  ///< what dabs of a stamp press; none: nothing was chosen
};

/// Books of what passes brought and took, on the device. New ones may be added at the end.
using Books = std::vector<gpu::Buffer*>;

/// Undo and redo. An entry keeps what an act changed, tile by tile, packed; or, where another terrain took
/// the place of the one before, the whole of that one. The newest entries that fit into the cap stay.
class Undo {
  public:
    /// Beyond this many bytes the oldest entries go.
    explicit Undo(std::size_t capacity_bytes) : capacity_bytes_(capacity_bytes) {}

    /// Opens an entry; what could be redone is dropped when it closes. No entry may be open.
    void open(std::string name, Terrain& terrain, const Books& books, const Journal& journal, Moment before);
    bool is_open() const { return open_; }
    /// True when the newest entry has this name and keeps no tiles, so that another change of the same
    /// parameter belongs to it; what could be redone is dropped then.
    bool extends(const std::string& name);
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
    /// Puts the packed terrain in place of the present one and gives that one back.
    using ExchangeTerrain = std::function<PackedTerrain(const PackedTerrain&)>;
    /// Both swap the terrain, the books and the moment with the entry's, and cut or restore the
    /// journal. `books` is asked for after a terrain was exchanged.
    void undo(Terrain& terrain, const std::function<Books()>& books, Journal& journal, Moment& now,
              const ExchangeTerrain& exchange);
    void redo(Terrain& terrain, const std::function<Books()>& books, Journal& journal, Moment& now,
              const ExchangeTerrain& exchange);

    /// Memory of all closed entries; the newest one counts as it came until it is packed.
    std::size_t bytes() const;

  private:
    struct Entry {
        std::string name;
        std::map<int, KeptTile> kept;  // as they were, while the entry is open
        TileChanges changes;           // of a closed one
        std::optional<PackedTerrain> terrain;
        std::vector<gpu::Buffer> books;
        Moment moment;
        Journal::Mark mark;           // before the act
        std::vector<Operation> tail;  // of the journal, while undone
        std::size_t bytes() const;
    };
    void swap(Entry& entry, Terrain& terrain, const std::function<Books()>& books, Moment& now,
              const ExchangeTerrain& exchange);
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
