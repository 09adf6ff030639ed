#pragma once
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "sim/journal.h"
#include "sim/parameters.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// What undo restores besides the layers.
struct Moment {
    Clock clock;
    Parameters parameters;
    std::vector<Spring> springs;
    double edges_since_s = 0;
    double sea_m3 = 0;        ///< water that sea levels brought so far
    double reweighed_m3 = 0;  ///< solid that changes of porosity and acceleration brought so far
};

/// Books of what passes brought and took, on the device. New ones may be added at the end.
using Books = std::vector<gpu::Buffer*>;

/// Undo and redo by tiles. An entry keeps the tiles as they were before an act, on the device; undoing swaps
/// them with the present ones, so that the same entry redoes. Nothing is read back.
class Undo {
  public:
    /// Beyond this many bytes the oldest entries go.
    explicit Undo(std::size_t capacity_bytes) : capacity_bytes_(capacity_bytes) {}

    /// Opens an entry and drops what could be redone. No entry may be open.
    void open(std::string name, Terrain& terrain, const Books& books, const Journal& journal, Moment before);
    bool is_open() const { return open_; }
    /// True when the newest entry has this name and keeps no tiles, so that another change of the same
    /// parameter belongs to it; what could be redone is dropped then.
    bool extends(const std::string& name);
    void set_capacity(std::size_t bytes);
    /// Keeps these tiles as they are now, once per entry. Call before they change.
    void keep(Terrain& terrain, const std::vector<int>& tiles);
    void keep_all(Terrain& terrain);
    /// Ends the open entry, if there is one. Tiles that did not change are let go; an entry during which
    /// nothing was recorded vanishes.
    void close(Terrain& terrain, const Journal& journal);

    bool can_undo() const { return !done_.empty(); }
    bool can_redo() const { return !undone_.empty(); }
    const std::string& undo_name() const { return done_.back().name; }
    const std::string& redo_name() const { return undone_.back().name; }
    /// Both swap the terrain, the books and the moment with the entry's, and cut or restore the
    /// journal.
    void undo(Terrain& terrain, const Books& books, Journal& journal, Moment& now);
    void redo(Terrain& terrain, const Books& books, Journal& journal, Moment& now);

    std::size_t bytes() const;

    /// A tile as it was: its solid and, behind it, each optional layer whose bit is set.
    struct KeptTile {
        gpu::Buffer texels;
        unsigned layers = 0;
    };

  private:
    struct Entry {
        std::string name;
        std::map<int, KeptTile> tiles;
        std::vector<gpu::Buffer> books;
        Moment moment;
        Journal::Mark mark;           // before the act
        std::vector<Operation> tail;  // of the journal, while undone
        std::size_t bytes = 0;
    };
    void swap(Entry& entry, Terrain& terrain, const Books& books, Moment& now);
    void trim();

    std::size_t capacity_bytes_;
    bool open_ = false;
    bool all_kept_ = false;
    std::deque<Entry> done_;
    std::vector<Entry> undone_;
};

}  // namespace talus
