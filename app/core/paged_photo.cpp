#include "app/core/paged_photo.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/core/tile_room.h"
#include "app/core/tile_waiting.h"
#include "sim/error.h"

namespace talus::app {
namespace {

// Texels of what is shown are as wide as a pixel at most; they are filtered over what a pixel covers.
constexpr double wanted_px = 1;

render::PhotoSurface surface_over(const io::PhotoFile& file, const Grid& ground,
                                  const std::optional<Georeference>& georeference,
                                  const HeightsBetween& heights, int mib) {
    const PhotoPlace place = file.place_over(ground, georeference);
    const TileTree tree = photo_tree(file.texels(), ground, place);
    return {
        tree, photo_bounds(tree, place, heights),
        slots_within({"tiles.photo_mib", mib, file.path()}, tree, render::PhotoSurface::bytes_of_slot(tree))};
}

ReadTexels reader_of(const io::PhotoFile& file) {
    return with_smaller_pictures(file.make_reader(), render::PhotoSurface::halvings);
}

}  // namespace

PagedPhoto::PagedPhoto(std::shared_ptr<const io::PhotoFile> file, const Grid& ground,
                       const std::optional<Georeference>& georeference, const HeightsBetween& heights,
                       int mib)
    : file_(std::move(file)),
      ground_(ground),
      surface_(surface_over(*file_, ground, georeference, heights, mib)),
      laid_{&surface_, file_->place_over(ground, georeference), 1, file_->covers(ground, georeference)},
      paging_(surface_.tree(), reader_of(*file_)) {
    const ReadTexels read = reader_of(*file_);
    std::vector<PhotoTexel> texels;
    for (const TileId& tile : surface_.tree().coarsest_tiles()) {
        read(tile.level, render::PhotoSurface::samples_of(surface_.tree(), tile), texels);
        surface_.put(tile, texels);
    }
}

void PagedPhoto::stand_within(const Grid& whole, const std::optional<Georeference>& georeference) {
    laid_around_ = {&surface_, file_->place_over(whole, georeference), laid_.changes,
                    file_->covers(whole, georeference)};
}

void PagedPhoto::look(const render::Camera& camera, glm::ivec2 size, double tolerance_px) {
    const render::TileChoice& choice =
        paging_.follow(surface_, laid_.camera_over(ground_, camera), size, tolerance_px);
    tolerance_px_ = choice.tolerance_px;
    if (nodes_ == choice.nodes && drawn_ == choice.drawn) return;
    nodes_ = choice.nodes;
    drawn_ = choice.drawn;
    laid_around_.changes = ++laid_.changes;
}

void PagedPhoto::follow(const render::Camera& camera, glm::ivec2 size) {
    look(camera, size, wanted_px);
}

void PagedPhoto::begin_still(const render::Camera& camera, glm::ivec2 size) {
    still_px_ = surface_.look(laid_.camera_over(ground_, camera), size, wanted_px).tolerance_px;
    largest_px_ = std::max(largest_px_, still_px_);
}

void PagedPhoto::wait_for_still(const render::Camera& camera, glm::ivec2 size) {
    wait_for_tiles(file_->path(), [&] {
        look(camera, size, still_px_);
        return paging_.on_their_way();
    });
}

std::string PagedPhoto::state() const {
    std::string text;
    if (paging_.on_their_way() > 0)
        text = fmt::format("{} tiles of the photo on their way", paging_.on_their_way());
    else if (tolerance_px_ > wanted_px)
        text = fmt::format("the photo's texels up to {:.1f} px: there is not enough tiles.photo_mib",
                           tolerance_px_);
    if (paging_.failed() > 0)
        text +=
            fmt::format("{}{} tiles of the photo cannot be read", text.empty() ? "" : ", ", paging_.failed());
    return text;
}

std::unique_ptr<PagedPhoto> photo_over(const Draping& draping, const Grid& ground,
                                       const std::optional<Georeference>& georeference,
                                       const HeightsBetween& heights, const Parameters& view) {
    if (!draping.photo) return nullptr;
    return std::make_unique<PagedPhoto>(draping.photo, ground, georeference, heights,
                                        view.whole("tiles.photo_mib"));
}

StillPainter with_photo(StillPainter painter, PagedPhoto& photo, const std::string& view, Missing missing) {
    if (!render::view_named(view).natural) return painter;
    StillPainter waiting = painter;
    waiting.begin = [begin = painter.begin, &photo](const render::Camera& camera, glm::ivec2 size) {
        if (begin) begin(camera, size);
        photo.begin_still(camera, size);
    };
    waiting.draw = [draw = painter.draw, &photo, missing](const render::Camera& camera, glm::ivec2 size) {
        photo.wait_for_still(camera, size);
        if (missing == Missing::refused && photo.failure()) throw Error(*photo.failure());
        draw(camera, size);
    };
    return waiting;
}

}  // namespace talus::app
