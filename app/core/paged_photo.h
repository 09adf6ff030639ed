#pragma once
#include <memory>
#include <optional>
#include <string>

#include "app/core/still.h"
#include "render/tiled/tile_paging.h"
#include "sim/io/photo_file.h"

namespace talus::app {

/// A photo over a ground on the device, and the tiles of it that come for pictures.
class PagedPhoto {
  public:
    /// heights: of the ground and what stands around it. mib: of the device's memory. Reads the coarsest
    /// tiles. Throws talus::Error where that fails, where there is too little memory, or the photo lies
    /// beside the ground.
    PagedPhoto(std::shared_ptr<const io::PhotoFile> file, const Grid& ground,
               const std::optional<Georeference>& georeference, const HeightsBetween& heights, int mib);

    const io::PhotoFile& file() const { return *file_; }
    /// How it lies over the ground, and what it shows since the last follow().
    const render::LaidPhoto& laid() const { return laid_; }
    /// The ground is a part of this one, in the same coordinate system.
    void stand_within(const Grid& whole, const std::optional<Georeference>& georeference);
    /// How it lies over that; before stand_within() there is nothing to be laid.
    const render::LaidPhoto& laid_around() const { return laid_around_; }
    const render::PhotoSurface& surface() const { return surface_; }

    /// Once a frame, before it is drawn with this camera over the ground, without waiting for a file.
    void follow(const render::Camera& camera, glm::ivec2 size);
    /// Before a still is drawn in parts: finds the one tolerance for all of them.
    void begin_still(const render::Camera& camera, glm::ivec2 size);
    /// Before a part is drawn: waits until all its tiles are there that can be read. Throws talus::Error
    /// where none comes for long.
    void wait_for_still(const render::Camera& camera, glm::ivec2 size);

    /// Why the last tile could not be read; none: the last still has all that it wanted.
    std::optional<std::string> failure() const {
        return paging_.failed() > 0 ? std::optional(paging_.last_error()) : std::nullopt;
    }
    /// Whether a frame is to follow without anybody's doing.
    bool has_news() const { return paging_.has_news(); }
    /// True while tiles are read.
    bool awaits_tiles() const { return paging_.reads(); }
    std::size_t drawn_tiles() const { return drawn_.size(); }  ///< of the last look
    std::size_t awaited_tiles() const { return paging_.on_their_way(); }
    /// Texels of all stills until now are at most so wide.
    double largest_px() const { return largest_px_; }
    /// CPU time that its reading thread has taken, seconds.
    double read_cpu_s() { return paging_.read_cpu_s(); }
    /// What the status line says of it; empty: nothing.
    std::string state() const;
    /// What is to be said of reading, once.
    std::optional<std::string> take_message() { return paging_.take_message(); }

  private:
    void look(const render::Camera& camera, glm::ivec2 size, double tolerance_px);

    std::shared_ptr<const io::PhotoFile> file_;
    Grid ground_;
    render::PhotoSurface surface_;
    render::LaidPhoto laid_;
    render::LaidPhoto laid_around_;
    std::vector<render::TileNode> nodes_;
    std::vector<TileId> drawn_;
    double tolerance_px_ = 0;
    double still_px_ = 0;
    double largest_px_ = 0;
    render::PhotoPaging paging_;  // last: its thread ends before what it looks at goes
};

/// A draping's photo over a ground, with `tiles.photo_mib` of the view; null: it has none. Throws as
/// PagedPhoto does.
std::unique_ptr<PagedPhoto> photo_over(const Draping& draping, const Grid& ground,
                                       const std::optional<Georeference>& georeference,
                                       const HeightsBetween& heights, const Parameters& view);

/// What is done where tiles of a photo cannot be read that a still wants.
enum class Missing {
    coarser,  ///< coarser ones are drawn
    refused   ///< talus::Error is thrown
};

/// The same painter, whose pictures wait for the photo's tiles where the view shows them. What it draws from
/// must have been laid under the photo (Renderer::lay()), which must outlive it.
StillPainter with_photo(StillPainter painter, PagedPhoto& photo, const std::string& view, Missing missing);

}  // namespace talus::app
