// Depths, m: below the first, water is a film without a surface; from the second on, it has a surface of its own. Between
// them the picture changes gradually, so that nothing shows where a sample crosses one of them.
const vec2 film_m = vec2(0.004, 0.02);
