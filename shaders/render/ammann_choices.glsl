// What a cell is drawn by: the mesh, or from by_rays on a level of precision of its rays, the highest first.
const uint by_mesh = 0u;
const uint by_rays = 1u;
const uint not_drawn = 255u;
