#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "render/tiled/photo_surface.h"
#include "render/tiled/tiled_surface.h"

namespace talus::render {

/// Brings tiles to a surface while pictures are drawn: one thread reads them, frames take what has come
/// (Dick, Krüger & Westermann 2009, section 4). A frame never waits for a file. Surface: what holds the
/// tiles, of heights or of a photo.
template <typename Surface>
class Paging {
  public:
    /// Reads tiles of this tree, on a thread of its own.
    Paging(const TileTree& tree, typename Surface::ReadTile read);
    ~Paging();
    Paging(const Paging&) = delete;
    Paging& operator=(const Paging&) = delete;

    /// Once a frame, before it is drawn: puts some of the tiles that have come, looks, and says what is to be
    /// read next: what the picture wants, the worst first, then what it will want if the camera goes on as it
    /// did since the frame before.
    const TileChoice& follow(Surface& surface, const Camera& camera, glm::ivec2 size, double tolerance_px);

    /// Tiles that the last picture wanted and that can be read, as far as is known: a later frame shows them.
    std::size_t on_their_way() const { return on_their_way_; }
    /// Tiles that the last picture wanted and that could not be read. They are tried again, and coarser ones
    /// are drawn.
    std::size_t failed() const { return failed_.size(); }
    /// Why the last one could not be; empty: all could be read until now.
    const std::string& last_error() const { return last_error_; }
    /// Whether a frame has something to do: tiles have come, or are to be tried again.
    bool has_news() const;
    /// True while the thread reads, or has been asked to.
    bool reads() const;
    /// A sentence where tiles that a picture wants begin to fail, and where they could be read again. Once
    /// for each.
    std::optional<std::string> take_message();
    /// CPU time that its thread has taken, seconds.
    double read_cpu_s();

  private:
    using Clock = std::chrono::steady_clock;
    struct Read {
        TileId tile;
        std::vector<typename Surface::Sample> samples;
        std::string error;  // empty: it was read
    };
    struct Failure {
        Clock::time_point next;  // then it is tried again
        Clock::duration wait;
    };

    void read_on();
    void take(Surface& surface);
    void note_failure(const Read& read);
    void ask(const std::vector<TileId>& tiles);
    void follow_failures();
    bool is_due(const TileId& tile) const;
    std::vector<TileId> due(const std::vector<TileId>& tiles) const;
    std::vector<TileId> ahead(Surface& surface, const Camera& camera, glm::ivec2 size,
                              double tolerance_px) const;

    TileTree tree_;
    typename Surface::ReadTile read_;
    std::optional<Camera> last_camera_;
    std::vector<TileId> wanted_;               // by the last picture
    std::map<std::size_t, Failure> failures_;  // by TileTree::index_of()
    std::size_t on_their_way_ = 0;
    std::set<std::size_t> failed_;  // of what is wanted, by TileTree::index_of()
    std::string last_error_;
    std::optional<std::string> message_;

    mutable std::mutex mutex_;  // of what follows
    std::condition_variable news_;
    std::vector<TileId> asked_;  // the next one last
    std::optional<TileId> reading_;
    std::deque<Read> come_;
    bool ending_ = false;
    std::thread thread_;  // last: it uses all of the above
};

using TilePaging = Paging<TiledSurface>;
using PhotoPaging = Paging<PhotoSurface>;

}  // namespace talus::render
