#include "render/tiled/tile_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace talus::render {
namespace {

// Tiles beside the picture throw shadows into it, and the camera may turn to them.
constexpr double unseen_divisor = 16;

// A tolerance that needs too much room is multiplied by this.
constexpr double coarsening_factor = 1.189207115;  // the fourth root of 2

// Around the eye an error has no bound in pixels; this counts for it, times its metres where they are more
// than one: where not all tiles fit that lie there, those of the largest errors go first.
constexpr double most_px = 1e6;

// The tile that the eye is over goes before all others: a coarser one may reach above the eye, which is then
// in the ground and sees nothing.
constexpr double own_tile = 1e8;

// No tile is as far off: a tolerance that all tiles keep.
constexpr double endless_px = 1e22;

struct Box {
    glm::dvec3 low;  // metres from the eye
    glm::dvec3 high;
    glm::dvec3 corner(int i) const {
        return {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
    }
};

// What a picture shows: a pyramid of directions, or a prism of parallel ones.
class Sight {
  public:
    Sight(const Camera& camera, glm::ivec2 size)
        : rays_(camera_rays(camera, size.x, size.y)),
          is_parallel_(camera.is_parallel()),
          pixel_m_(pixel_width_m(camera, size.y, 1)) {
        std::array<glm::dvec3, 4> corners{};
        for (int i = 0; i < 4; ++i) {
            const glm::dvec2 side(i == 1 || i == 2 ? 1 : -1, i < 2 ? -1 : 1);
            corners[i] = rays_.middle + side.x * rays_.right + side.y * rays_.up;
            widest_ = std::max(widest_, glm::dot(corners[i], corners[i]));
        }
        for (int i = 0; i < 4; ++i) inwards_[i] = glm::cross(corners[(i + 1) % 4], corners[i]);
        for (glm::dvec3& normal : inwards_)
            if (glm::dot(normal, rays_.middle) < 0) normal = -normal;
    }

    bool sees(const Box& box) const {
        if (is_parallel_) return is_before(box, rays_.start_right) && is_before(box, rays_.start_up);
        for (const glm::dvec3& normal : inwards_) {
            bool all_beside = true;
            for (int i = 0; i < 8; ++i) all_beside = all_beside && glm::dot(normal, box.corner(i)) < 0;
            if (all_beside) return false;
        }
        return true;
    }

    // Pixels that a point of the box moves by at most where it moves by so many metres: at an angle a from
    // the view's axis and a distance d, a step of m metres moves its picture by at most m / (d cos^2 a) of
    // its distance.
    // Of parallel rays it moves by no more than those metres, wherever it is.
    double pixels(const Box& box, double metres) const {
        if (is_parallel_) return std::min(metres / pixel_m_, most_px);
        const glm::dvec3 nearest = glm::clamp(glm::dvec3(0), box.low, box.high);
        const double distance_m = glm::length(nearest) - metres;
        if (distance_m <= metres / most_px) {
            const bool own = nearest.x == 0 && nearest.y == 0;
            return most_px * std::max(metres, 1.0) * (own ? own_tile : 1);
        }
        double widest = 1;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner = box.corner(i);
            const double depth = glm::dot(corner, rays_.forward);
            widest = depth > 0 ? std::max(widest, glm::dot(corner, corner) / (depth * depth)) : widest_;
            if (depth <= 0) break;
        }
        return std::min(metres / distance_m / pixel_m_ * std::min(widest, widest_), most_px);
    }

  private:
    // Whether some of the box lies between the picture's edges at both ends of a side.
    bool is_before(const Box& box, glm::dvec3 side) const {
        double low = std::numeric_limits<double>::max();
        double high = -low;
        for (int i = 0; i < 8; ++i) {
            const double at = glm::dot(box.corner(i) - rays_.start, side) / glm::dot(side, side);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        return low <= 1 && high >= -1;
    }

    CameraRays rays_;
    bool is_parallel_;
    double pixel_m_;     // width of a pixel, at a metre where rays run through the eye
    double widest_ = 1;  // 1 / cos^2 of the largest angle from the axis
    std::array<glm::dvec3, 4> inwards_{};
};

class Chooser {
  public:
    Chooser(const TileTree& tree, const std::vector<TileBounds>& bounds, const Camera& camera,
            glm::ivec2 size, const std::function<int(const TileId&)>& slot_of)
        : tree_(tree), bounds_(bounds), eye_(camera.eye), sight_(camera, size), slot_of_(slot_of) {}

    template <typename Visit>
    void for_roots(const Visit& visit) const {
        for (const TileId& tile : tree_.coarsest_tiles()) visit(tile);
    }

    template <typename Visit>
    void for_children(const TileId& tile, const Visit& visit) const {
        const glm::ivec2 tiles = tree_.level(tile.level - 1).tiles;
        for (int i = 0; i < 4; ++i) {
            const TileId child = {tile.level - 1, 2 * tile.column + i % 2, 2 * tile.row + i / 2};
            if (child.column < tiles.x && child.row < tiles.y) visit(child);
        }
    }

    // How many tiles a tolerance needs; at least one more than `room` where there are more.
    std::size_t needed(double tolerance_px, std::size_t room) const {
        std::size_t count = 0;
        for_roots([&](const TileId& root) { count_needed(root, tolerance_px, room, count); });
        return count;
    }

    TileChoice choose(double tolerance_px) {
        choice_.tolerance_px = tolerance_px;
        for_roots([&](const TileId& root) { draw(root, root); });
        std::stable_sort(wanted_.begin(), wanted_.end(),
                         [](const Wanted& a, const Wanted& b) { return a.off_px > b.off_px; });
        for (const Wanted& one : wanted_) choice_.wanted.push_back(one.tile);
        return std::move(choice_);
    }

  private:
    struct Wanted {
        TileId tile;
        double off_px;
    };

    Box box_of(const TileId& tile) const {
        const Grid& grid = tree_.grid();
        const glm::ivec2 first = tree_.first_patch(tile);
        const glm::ivec2 last = tree_.last_patch(tile);
        const TileBounds& bounds = bounds_[tree_.index_of(tile)];
        const double margin_m = bounds.error_m;
        return {glm::dvec3(first.x * grid.dx, (grid.ny - 1 - last.y) * grid.dy, bounds.lowest_m - margin_m) -
                    eye_,
                glm::dvec3(last.x * grid.dx, (grid.ny - 1 - first.y) * grid.dy, bounds.highest_m + margin_m) -
                    eye_};
    }

    // The tile's error in pixels, as far as it counts.
    double off_px(const TileId& tile) const {
        const double error_m = bounds_[tree_.index_of(tile)].error_m;
        if (error_m <= 0) return 0;
        const Box box = box_of(tile);
        return sight_.pixels(box, error_m) / (sight_.sees(box) ? 1 : unseen_divisor);
    }

    bool is_enough(const TileId& tile, double tolerance_px) const {
        return tile.level == 0 || (tolerance_px > 0 && off_px(tile) <= tolerance_px);
    }

    void count_needed(const TileId& tile, double tolerance_px, std::size_t room, std::size_t& count) const {
        if (count > room) return;
        // Tiles of the coarsest level have their own room.
        if (is_enough(tile, tolerance_px))
            count += tile.level < tree_.top_level() ? 1 : 0;
        else
            for_children(tile, [&](const TileId& child) { count_needed(child, tolerance_px, room, count); });
    }

    // source: the tile or one that it lies in, which is on the device.
    float draw(const TileId& tile, TileId source) {
        const int slot = slot_of_(tile);
        if (slot >= 0) source = tile;
        const bool enough = is_enough(tile, choice_.tolerance_px);
        bool finer = !enough;
        if (enough && slot < 0) {
            wanted_.push_back({tile, off_px(source)});
            // Where the next finer tiles are still here, they are drawn.
            finer = tile.level > 0;
            if (finer)
                for_children(tile, [&](const TileId& child) { finer = finer && slot_of_(child) >= 0; });
        }
        float highest_m = -std::numeric_limits<float>::infinity();
        if (finer && enough) {
            for_children(tile,
                         [&](const TileId& child) { highest_m = std::max(highest_m, show(child, child)); });
        } else if (finer) {
            for_children(tile,
                         [&](const TileId& child) { highest_m = std::max(highest_m, draw(child, source)); });
        } else {
            if (slot >= 0) choice_.needed.push_back(tile);
            return show(tile, source);
        }
        choice_.nodes.push_back({tile, -1, highest_m});
        return highest_m;
    }

    float show(const TileId& tile, const TileId& source) {
        const float highest_m = bounds_[tree_.index_of(source)].highest_m;
        choice_.nodes.push_back({tile, slot_of_(source), highest_m});
        choice_.drawn.push_back(source);
        return highest_m;
    }

    const TileTree& tree_;
    const std::vector<TileBounds>& bounds_;
    glm::dvec3 eye_;
    Sight sight_;
    const std::function<int(const TileId&)>& slot_of_;
    TileChoice choice_;
    std::vector<Wanted> wanted_;
};

}  // namespace

TileChoice choose_tiles(const TileTree& tree, const std::vector<TileBounds>& bounds, const Camera& camera,
                        glm::ivec2 size, double tolerance_px, std::size_t room,
                        const std::function<int(const TileId&)>& slot_of) {
    Chooser chooser(tree, bounds, camera, size, slot_of);
    while (tolerance_px < endless_px && chooser.needed(tolerance_px, room) > room)
        tolerance_px = std::max(tolerance_px * coarsening_factor, 1.0 / 16);
    return chooser.choose(tolerance_px);
}

}  // namespace talus::render
