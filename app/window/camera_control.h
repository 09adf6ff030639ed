#pragma once
#include "render/camera.h"
#include "sim/terrain/reshape.h"

namespace talus::app {

/// Turns the camera about a point on the ground by a drag of the mouse, in pixels.
void orbit(render::Camera& camera, glm::dvec3 pivot, double drag_x, double drag_y);
/// Turns the camera about its own eye.
void look(render::Camera& camera, double drag_x, double drag_y);
/// Turns the camera up or down until it looks level.
void look_level(render::Camera& camera);
/// Moves eye and target sideways with the ground under the mouse; distance: of that ground.
void pan(render::Camera& camera, double drag_x, double drag_y, double distance_m, int picture_height);
/// Towards or away from a point; steps of the wheel.
void zoom(render::Camera& camera, glm::dvec3 towards, double steps);
/// Flies: metres ahead, to the right and up.
void fly(render::Camera& camera, double ahead_m, double right_m, double up_m);

/// Walks over level metres ahead and to the right, wherever the camera looks up or down.
void walk(render::Camera& camera, double ahead_m, double right_m);
/// From a view through the eye to the orthographic one straight down, over the ground that it looks at and
/// about as near; to all of the terrain where it saw about that much. aspect: of the picture, width by
/// height.
void look_from_top(render::Camera& camera, const Grid& grid, double highest_m, double aspect,
                   glm::dvec3 ground);
/// And back: looks in this direction at the ground in the picture's middle, or, who is to walk, from there.
void leave_top(render::Camera& camera, glm::dvec3 direction, double ground_m, bool walks);
/// Of an orthographic view: nearer or farther by steps of the wheel; what is under the mouse stays there.
void zoom_from_top(render::Camera& camera, glm::dvec3 towards, double steps, const Grid& grid);

/// Brings the eye towards a height, as fast as a person's legs even out the ground: most of the way within
/// 0.2 s, and never lower than `lowest_m`.
void stand(render::Camera& camera, double height_m, double lowest_m, double passed_s);
/// Brings eye and target together over the terrain's rectangle.
void keep_within(render::Camera& camera, const Rectangle& ground);
/// Lifts eye and target together so that the eye is no lower.
void keep_above(render::Camera& camera, double lowest_m);

/// The ray through a pixel (x right, y down from the upper left): where it starts, and its direction, of unit
/// length.
struct PixelRay {
    glm::dvec3 start{0};
    glm::dvec3 direction{0};
};
PixelRay pixel_ray(const render::Camera& camera, double x, double y, int width, int height);

}  // namespace talus::app
